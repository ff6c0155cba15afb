// The cloud of powder: drawn in coarse pixels of its own, and laid over the picture: render/passes/powder_pass.cpp.
const kFinestPowder = 2, kCoarsestPowder = 4;         // divisors of the resolution
const kLeastBudget = 30000, kBudgetPerSample = 0.07;  // pixels of puffs
const kRim = 1, kCoarseRim = 3;                       // pixels around the box of the cloud

class Cloud {
    constructor(gpu, slide, shaders, slots, frame) {
        const {gl} = gpu;
        Object.assign(this, {gpu, slide, shaders, slots, frame});
        this.puffs = new PowderPuffs(slide, slots);
        this.block = gl.createBuffer();
        gl.bindBuffer(gl.UNIFORM_BUFFER, this.block);
        gl.bufferData(gl.UNIFORM_BUFFER, 8 * 16, gl.DYNAMIC_DRAW);
        gl.bindBufferBase(gl.UNIFORM_BUFFER, slots.SLOT_POWDER, this.block);
        this.array = gl.createVertexArray();
        this.instances = gl.createBuffer();
        gl.bindVertexArray(this.array);
        gl.bindBuffer(gl.ARRAY_BUFFER, this.instances);
        for (const location of [0, 1, 2]) gpu.attribute(location, 4, 4 * kPuffNumbers, 16 * location, 1);
        gl.bindVertexArray(null);
        this.shade = gpu.texture(slots.SLOT_POWDER_SHADE, gl.RG32F, kShadeSide, kShadeSide, gl.NEAREST);
        this.made = [];
        this.targets = {};
    }

    resize(width, height) {
        const {gpu, gpu: {gl}, slots} = this, half = size => Math.ceil(size / kFinestPowder);
        for (const texture of this.made) gl.deleteTexture(texture);
        for (const target of Object.values(this.targets)) gl.deleteFramebuffer(target);
        this.width = width;
        this.height = height;
        const make = (slot, format, filter = gl.NEAREST) =>
            gpu.texture(slots[slot], format, half(width), half(height), filter);
        this.reach = make('SLOT_POWDER_REACH', gl.R32F);
        this.thick = make('SLOT_POWDER_THICK', gl.RGBA16F);
        this.lower = make('SLOT_POWDER_LOWER', gl.R16F);
        this.lit = make('SLOT_POWDER_LIT', gl.RGBA16F, gl.LINEAR);
        this.hidden = make('SLOT_POWDER_HIDDEN', gl.RGBA32F);
        this.made = [this.reach, this.thick, this.lower, this.lit, this.hidden];
        this.targets = {reach: gpu.target([this.reach]), thick: gpu.target([this.thick, this.lower]),
                        lit: gpu.target([this.lit, this.hidden])};
    }

    // Draws the cloud of the moment. Returns whether there is any. Reads the depth of the ground.
    draw(view) {
        const {gpu, gpu: {gl}, slots, puffs, shaders, targets} = this;
        if (!puffs.find(this.slide.tick, view, this.frame.sun)) return false;
        const samples = this.width * this.height, budget = kLeastBudget + kBudgetPerSample * samples;
        const tooMany = puffs.covered * samples / budget;
        const divisor = tooMany > kFinestPowder * kFinestPowder ? kCoarsestPowder : kFinestPowder;
        const width = Math.ceil(this.width / divisor), height = Math.ceil(this.height / divisor);
        this.send(divisor);
        for (const slot of ['REACH', 'THICK', 'LOWER', 'LIT', 'HIDDEN']) gpu.bind(slots['SLOT_POWDER_' + slot], null);
        gl.scissor(...this.box(width, height, kCoarseRim));
        gpu.enabled([gl.SCISSOR_TEST], () => {
            gpu.into(targets.reach, width, height);
            gpu.fill(shaders.reach);
            gpu.bind(slots.SLOT_POWDER_REACH, this.reach);

            gpu.into(targets.thick, width, height);
            for (const part of [0, 1]) gl.clearBufferfv(gl.COLOR, part, [0, 0, 0, 0]);
            gl.blendFunc(gl.ONE, gl.ONE_MINUS_SRC_ALPHA);
            gpu.enabled([gl.BLEND], () => {
                shaders.puffs.use();
                gl.bindVertexArray(this.array);
                gl.drawArraysInstanced(gl.TRIANGLES, 0, 6, puffs.count);
            });
            gpu.bind(slots.SLOT_POWDER_THICK, this.thick);
            gpu.bind(slots.SLOT_POWDER_LOWER, this.lower);

            gpu.into(targets.lit, width, height);
            gpu.fill(shaders.cloudLight);
            gpu.bind(slots.SLOT_POWDER_LIT, this.lit);
            gpu.bind(slots.SLOT_POWDER_HIDDEN, this.hidden);
        });
        return true;
    }

    // Lays it over the picture that is drawn into. First it takes light from that, then it adds its own: WebGL has no
    // blending of two colours.
    layOver() {
        const {gpu, gpu: {gl}, shaders} = this;
        gl.scissor(...this.box(this.width, this.height, kRim));
        gpu.enabled([gl.SCISSOR_TEST, gl.BLEND], () => {
            gl.blendFunc(gl.ZERO, gl.ONE_MINUS_SRC_COLOR);
            gpu.fill(shaders.overTaken);
            gl.blendFunc(gl.ONE, gl.ONE);
            gpu.fill(shaders.overAdded);
        });
    }

    // Left, bottom, width and height of the cloud's box, and `rim` more, in pixels of a picture of this size.
    box(width, height, rim) {
        const [left, bottom, right, top] = this.puffs.box, pixel = (at, size) => Math.floor((0.5 + 0.5 * at) * size);
        const x = pixel(left, width) - rim, y = pixel(bottom, height) - rim;
        return [x, y, pixel(right, width) + rim + 1 - x, pixel(top, height) + rim + 1 - y];
    }

    // The uniforms of powder.glsl, the puffs, and their shade.
    send(divisor) {
        const {gpu, gpu: {gl}, slots, puffs, slide: {info}} = this, bytes = new ArrayBuffer(8 * 16);
        const put = (i, numbers) => new Float32Array(bytes, 16 * i).set(numbers);
        const across = this.width / divisor, up = this.height / divisor;
        const texel = [this.width, this.height].map(size => 1 / Math.ceil(size / kFinestPowder));
        const lamp = this.frame.floats('lamp'), above = this.frame.floats('above'), steep = this.frame.sun[2];
        const lost = [0, 1, 2].map(k => lamp[k] * steep / (lamp[k] * steep + above[k]));
        put(0, [...info.powder.colour, puffs.meanRadius]);
        put(1, [...info.lower_powder.colour, puffs.mixed ? 1 : 0]);
        put(2, puffs.shade.across);
        put(3, puffs.shade.up);
        new Int32Array(bytes, 64, 4).fill(divisor);
        put(5, [across, up, 1 / divisor, 0]);
        put(6, [...texel, (Math.ceil(across) - 0.5) * texel[0], (Math.ceil(up) - 0.5) * texel[1]]);
        put(7, [...lost.map(share => lost[0] - share), lost[0]]);
        gl.bindBuffer(gl.UNIFORM_BUFFER, this.block);
        gl.bufferSubData(gl.UNIFORM_BUFFER, 0, bytes);
        gl.bindBuffer(gl.ARRAY_BUFFER, this.instances);
        gl.bufferData(gl.ARRAY_BUFFER, puffs.drawn.subarray(0, kPuffNumbers * puffs.count), gl.STREAM_DRAW);
        gpu.upload(slots.SLOT_POWDER_SHADE, this.shade, kShadeSide, kShadeSide, puffs.shade.cells);
    }
}
