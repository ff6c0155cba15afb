// What is on the ground and around it: mountains, what people have built, trees, and snow that wind blows off ridges.

// What is packed of each vertex of structures, ropes and shadows, in the order of their shaders' attributes.
const kBuiltColumns = {
    built: ['x', 'y', 'z', 'material', 'normal_x', 'normal_y', 'normal_z', 'number', 'across', 'up', 'light', 'own',
            'rests_x', 'rests_y', 'rests_z', 'rests'],
    ropes: ['x', 'y', 'z', 'side', 'along_x', 'along_y', 'along_z', 'half'],
    shadows: ['x', 'y', 'z', 'strength', 'foot_x', 'foot_y', 'foot_z', 'is_light'],
};
// How far a shadow on the ground is drawn in front of it: by its slope, and in the smallest steps of depth.
const kShadowOffset = [2, 8];

class Scenery {
    constructor(gpu, slide, shaders, slots, frame) {
        Object.assign(this, {gpu, slide, shaders, slots, frame});
        if (shaders.around) this.makeMountains();
        if (shaders.built) this.makeBuilt();
        if (shaders.tree) this.makeTrees();
        if (shaders.spindrift) this.makeRidges();
    }

    makeMountains() {
        const {gpu, gpu: {gl}, slide, slots} = this, {nx, ny} = slide.info.grid;
        const names = ['x', 'y', 'z', 'slope_x', 'slope_y', 'source_x', 'source_y', 'cover_d', 'cover_l', 'open', 'on',
                       'sun'];
        const columns = names.map(name => slide.array('around.' + name)), none = new Float32Array(columns[0].length);
        const vertices = gpu.vertices(columns.map(column => column ?? none), [3, 4, 4, 1]);
        this.mountains = gpu.mesh(Uint32Array.from(slide.array('around.index')), vertices);

        // Mip-mapped, because a pixel of far mountains covers many vertices of the grid.
        const depth = slide.array('cover_d'), lower = slide.array('cover_l'), cover = new Float32Array(2 * nx * ny);
        depth.forEach((value, i) => cover.set([value, lower ? lower[i] : 0], 2 * i));
        gpu.mipMapped(slots.SLOT_FIRST_COVER, gl.RG16F, nx, ny, cover);
        gpu.clampToEdge();
    }

    makeBuilt() {
        const {gpu, slide} = this;
        this.built = {};
        for (const [table, names] of Object.entries(kBuiltColumns)) {
            const column = name => slide.array(`${table}.${name}`);
            if (!column('x')) continue;
            const array = gpu.vertices(names.map(column), Array(names.length / 4).fill(4));
            const [first, count, from, until] = ['first', 'count', 'from', 'until'].map(column);
            this.built[table] = {array, pieces: Array.from(first, (_, i) =>
                ({first: first[i], count: count[i], from: from[i], until: until[i]}))};
        }
    }

    // As they are in a world that goes on: vertices one after another, in the order of kBuiltColumns.
    rebuild() {
        const {gpu: {gl}, gpu} = this;
        this.builtVersion = this.slide.builtVersion;
        this.built ??= {};
        Object.entries(kBuiltColumns).forEach(([table, names], which) => {
            const numbers = this.slide.built[which];
            if (this.live?.[table]) gl.deleteBuffer(this.live[table]);
            const {array, buffer} = gpu.interleaved(numbers, Array(names.length / 4).fill(4));
            this.live = {...this.live, [table]: buffer};
            this.built[table] = {array, pieces: [{first: 0, count: numbers.length / names.length}]};
        });
    }

    makeTrees() {
        const {slots} = this;
        this.trees = new TreesInView(this.slide, this.frame.sun, slots);
        this.treePictures = this.makeTreePictures();
        this.makeTreeTexture();
    }

    // With a row for every kTreesInARow trees.
    makeTreeTexture() {
        const {gpu, gpu: {gl}, slots} = this, rows = Math.max(Math.ceil(this.trees.x.length / kTreesInARow), 1);
        if (rows <= (this.treeRows ?? 0)) return;
        gl.deleteTexture(this.treeTexture ?? null);
        this.treeRows = rows;
        this.treeTexture = gpu.texture(slots.SLOT_UNITS, gl.RGBA32F, kTreeNumbers / 4 * kTreesInARow, rows, gl.NEAREST);
    }

    // Those of trees in leaf are beside the others, if the page has any.
    makeTreePictures() {
        const {gpu, gpu: {gl}, slots, slide} = this;
        const files = ['trees.pictures', 'trees.in_leaf'].filter(name => slide.info.arrays[name]);
        const width = slots.TREE_COLUMNS * slots.TREE_TILE_WIDTH, height = slots.TREE_ROWS * slots.TREE_TILE_HEIGHT;
        const finest = slots.TREE_FINEST_IN_PAGES, levels = slots.TREE_LEVELS - finest;
        const pictures = gl.createTexture();
        gpu.bind(slots.SLOT_TREE_PICTURES, pictures);
        gl.texStorage2D(gl.TEXTURE_2D, levels, gl.RGB8, files.length * width >> finest, height >> finest);
        gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MIN_FILTER, gl.NEAREST_MIPMAP_NEAREST);
        gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MAG_FILTER, gl.NEAREST);
        gl.pixelStorei(gl.UNPACK_ALIGNMENT, 1);
        files.forEach((name, file) => this.uploadTreePictures(slide.quanta(name), file * width, width, height));
        return pictures;
    }

    // The levels are below each other, lowest row first. A number has the three parts of a texel.
    uploadTreePictures(packed, left, width, height) {
        const {gpu: {gl}, slots} = this, finest = slots.TREE_FINEST_IN_PAGES;
        let first = 0;
        for (let level = finest; level < slots.TREE_LEVELS; ++level) {
            const wide = width >> level, high = height >> level, texels = new Uint8Array(3 * wide * high);
            for (let i = 0; i < wide * high; ++i) {
                const texel = packed[first + i];
                texels.set([17 * (texel >> 9), 17 * (texel >> 5 & 15), Math.round((texel & 31) * 255 / 31)], 3 * i);
            }
            gl.texSubImage2D(gl.TEXTURE_2D, level - finest, left >> level, 0, wide, high, gl.RGB, gl.UNSIGNED_BYTE, texels);
            first += wide * high;
        }
    }

    makeRidges() {
        const columns = ['x', 'y', 'z', 'strength', 'chance', 'sun'].map(name => this.slide.array('ridges.' + name));
        this.ridges = {array: this.gpu.vertices(columns, [3, 3], 1), count: columns[0].length};
    }

    drawMountains() {
        const {gpu, gpu: {gl}} = this;
        gpu.enabled([gl.DEPTH_TEST, gl.CULL_FACE], () => gpu.drawMesh(this.shaders.around, this.mountains));
    }

    // What people have built, as it is in the stored frame before the moment.
    drawBuilt() {
        const {gpu, gpu: {gl}, slide: {tick, info}} = this;
        if (this.slide.builtVersion > (this.builtVersion ?? 0)) this.rebuild();
        if (!this.built) return;
        const frame = Math.min(Math.floor(tick / info.every), info.frames - 1);
        const draw = table => {
            if (!this.built[table]) return;
            this.shaders[table].use();
            gl.bindVertexArray(this.built[table].array);
            for (const {first, count, from, until} of this.built[table].pieces)
                if ((from <= frame && frame < until) || this.builtVersion) gl.drawArrays(gl.TRIANGLES, first, count);
        };
        gpu.enabled([gl.DEPTH_TEST], () => {
            draw('built');
            this.drawShadows(() => draw('shadows'));
            gl.depthMask(false);
            gl.blendFunc(gl.SRC_ALPHA, gl.ONE_MINUS_SRC_ALPHA);
            gpu.enabled([gl.BLEND], () => draw('ropes'));
            gl.depthMask(true);
        });
    }

    // A shadow lies on the ground as triangles, which are a little above it everywhere.
    drawShadows(draw) {
        const {gpu, gpu: {gl}} = this;
        gl.depthMask(false);
        gl.blendFunc(gl.ZERO, gl.SRC_COLOR);
        gl.polygonOffset(...kShadowOffset);
        gpu.enabled([gl.BLEND, gl.POLYGON_OFFSET_FILL], draw);
        gl.depthMask(true);
    }

    // How its patterns travel is as in render/passes/spindrift_pass.cpp.
    drawSpindrift() {
        const {gpu, gpu: {gl}, shaders: {spindrift}, slide: {tick, info}} = this;
        const speed = Math.hypot(...info.wind), gone = tick * info.tick_s * speed;
        spindrift.use();
        gl.uniform4f(spindrift.at('wind'), info.wind[0] / speed, info.wind[1] / speed, speed, 0);
        const phase = [fraction(gone * 1.25 / 44), fraction(gone / 97), fraction(0.5 * gone / 430), 0];
        gl.uniform4fv(spindrift.at('phase'), phase);
        gl.bindVertexArray(this.ridges.array);
        gl.blendFunc(gl.ONE, gl.ONE_MINUS_SRC_ALPHA);
        gpu.enabled([gl.BLEND], () => gl.drawArraysInstanced(gl.TRIANGLES, 0, 6, this.ridges.count));
    }

    // `onScreen`: where a box is seen; null: nowhere.
    drawTrees(view, onScreen) {
        const {gpu, gpu: {gl}, slots, trees, shaders} = this;
        if (!trees) return;
        if (this.planted !== this.slide.planted) {
            this.planted = this.slide.planted;
            trees.plant(this.planted);
            this.makeTreeTexture();
            this.treesKey = null;
        }
        const key = [...view.clip, view.pixel].join();
        if (key !== this.treesKey) trees.find(view, onScreen);
        if (key !== this.treesKey || this.treesVersion !== this.slide.version) {
            const rows = trees.settle(), width = kTreeNumbers / 4 * kTreesInARow;
            const numbers = trees.drawn.subarray(0, 4 * width * rows);
            if (rows > 0) gpu.upload(slots.SLOT_UNITS, this.treeTexture, width, rows, numbers);
        }
        this.treesKey = key;
        this.treesVersion = this.slide.version;
        gpu.bind(slots.SLOT_TREE_PICTURES, this.treePictures);
        gpu.enabled([gl.DEPTH_TEST], () => {
            this.drawShadows(() => gpu.drawNumbers(shaders.treeShadow, 0, 3 * trees.withShadow));
            gpu.drawNumbers(shaders.tree, 0, 3 * trees.standing.length);
        });
    }
}
