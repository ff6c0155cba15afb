// The picture: draws a slide at its moment with the program's own shaders, in the order of render/frame.cpp.

const kDetailSize = 512;                               // texels along the small relief's tile
const kScreenTile = 32;                                // samples along an edge
const kSlideBlock = 4, kSlideReach = 3, kWallReach = 2;  // vertices: render/slide_tiles.cpp
const kCoarsest = 4, kFinest = 2;                      // divisors of the resolution for powder
const kLeastBudget = 30000, kBudgetPerSample = 0.07;   // pixels of puffs
const kDebrisTiles = 9;                                // along the longer side
// What is packed of each vertex of structures, and of their ropes and shadows, in the order of their shaders' attributes.
const kBuiltColumns = {
    built: ['x', 'y', 'z', 'material', 'normal_x', 'normal_y', 'normal_z', 'number', 'across', 'up', 'light', 'own', 'rests_x', 'rests_y',
            'rests_z', 'rests'],
    ropes: ['x', 'y', 'z', 'side', 'along_x', 'along_y', 'along_z', 'half'],
    shadows: ['x', 'y', 'z', 'strength', 'foot_x', 'foot_y', 'foot_z', 'zero'],
};

class Picture {
    // Throws an error whose message is a sentence for the viewer.
    static async create(canvas, slide) {
        const gl = canvas.getContext('webgl2', {antialias: false, depth: false, alpha: false, powerPreference: 'high-performance'});
        if (!gl) throw new Error('This browser cannot draw WebGL 2. Try another browser, or allow graphics acceleration in its settings.');
        if (!gl.getExtension('EXT_color_buffer_float'))
            throw new Error('This graphics card cannot draw into textures of floating-point numbers, which this page needs. Try another device.');
        const picture = new Picture(gl, slide);
        picture.compile();
        await picture.shaders.ready();
        picture.makeTerrain();
        return picture;
    }

    constructor(gl, slide) {
        this.gl = gl;
        this.slide = slide;
        this.shaders = new Shaders(gl, name => slide.file(name));
        this.slots = this.shaders.constants;
        const names = gl.getExtension('WEBGL_debug_renderer_info');
        this.renderer = gl.getParameter(names ? names.UNMASKED_RENDERER_WEBGL : gl.RENDERER);
        this.block = Uint8Array.from(atob(slide.info.frame), letter => letter.charCodeAt(0)).buffer;
        this.noVertices = gl.createVertexArray();
        this.target = {width: 0, height: 0};
        this.passes = null;  // ms by name while they are measured
    }

    // ---- shaders ----

    compile() {
        const {slide} = this, frame = ['slots.glsl', 'frame.glsl'], light = [...frame, 'light.glsl'], lit = [...light, 'sun_ceiling.glsl'];
        const add = (vertex, fragment, out) => this.shaders.add(vertex, fragment, out);
        const fullscreen = ['fullscreen.vert'];
        this.programs = {
            openness: add(fullscreen, [...frame, 'openness.glsl', 'openness.frag']),
            surface: add(fullscreen, [...frame, 'cover.glsl', 'surface.glsl', 'surface.frag']),
            detailHeights: add(fullscreen, ['slots.glsl', 'detail_heights.frag']),
            detailRange: add(fullscreen, ['slots.glsl', 'detail_range.frag']),
            detailLayer: add(fullscreen, ['slots.glsl', 'detail_layer.frag']),
            depth: add([...frame, 'terrain.vert'], ['depth.frag']),
            sky: add(fullscreen, [...light, 'sky.frag']),
            lights: add(fullscreen, [...frame, 'sky_lights.frag', this.number('above', 3) > 0 ? 'stars.glsl' : 'stars_none.glsl']),
            tone: add(fullscreen, ['slots.glsl', 'tone_curve.glsl', 'encoded_before.glsl', 'tone.frag', 'encoded.frag']),
            copied: add(fullscreen, ['slots.glsl', 'copied.frag']),
            edgeMarks: add(fullscreen, ['slots.glsl', 'gather.glsl', 'edges_mark.frag']),
            edges: add(fullscreen, ['slots.glsl', 'gather.glsl', 'edges.frag']),
        };
        if (slide.info.texture)
            this.programs.debris = add(['rectangles.vert'], [...frame, 'window_depth.glsl', 'debris.frag', 'grain.glsl', 'paint_blended.glsl']);
        this.materials = slide.info.two ? 'materials_two.glsl' : 'materials_one.glsl';
        this.shadings = new Map();
        this.shading('marks_none.glsl');
        if (slide.info.surroundings)
            this.programs.around = add([...frame, 'cover.glsl', 'surroundings.vert'],
                                       [...frame, 'cover.glsl', 'light.glsl', 'ground.glsl', 'surroundings.frag',
                                        slide.info.two ? 'surroundings_two.glsl' : 'surroundings_one.glsl']);
        else
            this.programs.walls = add([...frame, 'terrain.vert'], [...lit, 'gather.glsl', 'walls.frag']);
        if (slide.info.arrays['built.x'])
            Object.assign(this.programs, {
                built: add([...lit, 'triangle_height.glsl', 'structure.vert'], [...frame, 'structure.frag']),
                ropes: add([...lit, 'rope.vert'], ['rope.frag']),
                shadows: add([...lit, 'triangle_height.glsl', 'structure_shadow.vert'], ['structure_shadow.frag']),
            });
        if (slide.info.arrays['trees.x']) {
            const tree = (vertex, fragment) => add([...light, 'tree.glsl', 'tree_texture.glsl', vertex], ['slots.glsl', fragment]);
            Object.assign(this.programs, {
                treeShadow: tree('tree_shadow.vert', 'tree_shadow.frag'), treeFar: tree('tree_far.vert', 'tree_far.frag'),
                treePlain: tree('tree_plain.vert', 'tree_plain.frag'), treeNear: tree('tree_near.vert', 'tree_near.frag'),
            });
        }
        if (slide.info.arrays['puffs.x']) {
            const over = [...frame, 'powder.glsl', 'window_depth.glsl', 'powder_over.frag'];
            Object.assign(this.programs, {
                reach: add(fullscreen, [...frame, 'powder.glsl', 'window_depth.glsl', 'powder_reach.frag']),
                puffs: add([...frame, 'sun_ceiling.glsl', 'powder.glsl', 'powder.vert'], [...frame, 'powder.glsl', 'powder.frag']),
                cloudLight: add(fullscreen, [...lit, 'powder.glsl', 'powder_light.frag']),
                overAdded: add(fullscreen, over, 0), overTaken: add(fullscreen, over, 1),
            });
        }
    }

    // The terrain's shaders with some marks: where a slab broke off, where a slide is or was, and elsewhere.
    shading(...marks) {
        const key = marks.join();
        if (!this.shadings.has(key)) {
            const make = (slides, crown) => this.shaders.add(['rectangles.vert'],
                ['slots.glsl', 'frame.glsl', 'light.glsl', 'sun_ceiling.glsl', 'ground.glsl', 'tone_curve.glsl', 'spline.glsl',
                 'window_depth.glsl', 'terrain.frag', this.materials, slides, crown, ...marks]);
            this.shadings.set(key, [make('slides_none.glsl', 'crown_none.glsl'), make('slides.glsl', 'crown_none.glsl'),
                                    make('slides.glsl', 'crown.glsl')]);
        }
        return this.shadings.get(key);
    }

    // Begins to compile what is needed once a legend or a point is chosen.
    prepareMarks() {
        if (this.gl.isContextLost()) return;
        for (const overlay of ['overlay.glsl', 'overlay_none.glsl']) this.shading('marks.glsl', overlay);
    }

    // ---- the uniforms of the frame ----

    // Where a member of the block of frame.glsl lies, in bytes; in C++ and in std140 all are packed alike.
    place(member) {
        if (!this.places) {
            this.places = {};
            let at = 0;
            for (const [, type, name, count] of this.slide.file('frame.glsl').matchAll(/^\s+(mat4|i?vec4) (\w+)(?:\[(\w+)\])?;/gm)) {
                this.places[name] = at;
                at += (type === 'mat4' ? 64 : 16) * (count ? this.slots[count] : 1);
            }
        }
        return this.places[member];
    }

    floats(member, count = 4) { return new Float32Array(this.block, this.place(member), count); }
    integers(member) { return new Int32Array(this.block, this.place(member), 4); }
    number(member, part) { return this.floats(member)[part]; }

    setFrame(overlay, cursor) {
        const {gl, view} = this;
        this.floats('clip_from_world', 16).set(view.clip);
        this.floats('eye').set(view.eye);  // and keeps its w
        this.floats('ray_forward').set([...view.forward, view.near]);
        this.floats('ray_right').set(view.right);
        this.floats('ray_up').set(view.up);
        this.floats('material').set([view.pixel, Math.max(this.scale, 1)], 1);
        this.floats('flow').set(this.debrisTint ? [kDebrisTiles / this.side, this.slots.FLOW_ROLLING, 0, 0] : [0, 0, 0, 0]);
        if (this.debrisTint) this.floats('flow_tint').set(this.debrisTint);
        const cell = this.slide.info.grid.dx;
        this.floats('ring').set(cursor ? [cursor.x, cursor.y, cursor.radius || 1.5 * cell, 1] : [0, 0, 0, 0]);
        this.floats('ring_colour').set([1, 0.55, 0.05, 0]);
        this.integers('overlay').set(overlay ? [this.slots.OVERLAY_SPEED, overlay.stops.length, overlay.stepped ? 1 : 0, 0] : [0, 0, 0, 0]);
        if (overlay) this.floats('stops', 4 * overlay.stops.length).set(this.legend(overlay));
        gl.bindBufferBase(gl.UNIFORM_BUFFER, this.slots.SLOT_FRAME, this.frameBuffer);
        gl.bufferSubData(gl.UNIFORM_BUFFER, 0, this.block);
    }

    // ---- textures ----

    texture(unit, format, width, height, filter, data = null) {
        const {gl} = this, texture = gl.createTexture();
        gl.activeTexture(gl.TEXTURE0 + unit);
        gl.bindTexture(gl.TEXTURE_2D, texture);
        gl.texStorage2D(gl.TEXTURE_2D, 1, format, width, height);
        for (const which of [gl.TEXTURE_MIN_FILTER, gl.TEXTURE_MAG_FILTER]) gl.texParameteri(gl.TEXTURE_2D, which, filter);
        for (const which of [gl.TEXTURE_WRAP_S, gl.TEXTURE_WRAP_T]) gl.texParameteri(gl.TEXTURE_2D, which, gl.CLAMP_TO_EDGE);
        if (data) this.upload(unit, texture, width, height, data);
        return texture;
    }

    bind(unit, texture) {
        this.gl.activeTexture(this.gl.TEXTURE0 + unit);
        this.gl.bindTexture(this.gl.TEXTURE_2D, texture);
    }

    // Numbers of one to four parts, as the array's length has it.
    upload(unit, texture, width, height, data) {
        const {gl} = this, parts = data.length / (width * height);
        this.bind(unit, texture);
        gl.pixelStorei(gl.UNPACK_ALIGNMENT, 1);
        if (data instanceof Float32Array)
            gl.texSubImage2D(gl.TEXTURE_2D, 0, 0, 0, width, height, [gl.RED, gl.RG, gl.RGB, gl.RGBA][parts - 1], gl.FLOAT, data);
        else
            gl.texSubImage2D(gl.TEXTURE_2D, 0, 0, 0, width, height, [gl.RED_INTEGER, gl.RG, gl.RGB, gl.RGBA][parts - 1], gl.UNSIGNED_BYTE, data);
    }

    framebuffer(colours, depth = null) {
        const {gl} = this, buffer = gl.createFramebuffer();
        gl.bindFramebuffer(gl.FRAMEBUFFER, buffer);
        colours.forEach((texture, i) => gl.framebufferTexture2D(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT0 + i, gl.TEXTURE_2D, texture, 0));
        if (depth) gl.framebufferTexture2D(gl.FRAMEBUFFER, gl.DEPTH_ATTACHMENT, gl.TEXTURE_2D, depth, 0);
        gl.drawBuffers(colours.length > 0 ? colours.map((_, i) => gl.COLOR_ATTACHMENT0 + i) : [gl.NONE]);
        return buffer;
    }

    // ---- what is made once ----

    makeTerrain() {
        const {gl, slide, slots} = this, {nx, ny} = slide.info.grid;
        this.frameBuffer = gl.createBuffer();
        gl.bindBuffer(gl.UNIFORM_BUFFER, this.frameBuffer);
        gl.bufferData(gl.UNIFORM_BUFFER, this.block, gl.DYNAMIC_DRAW);
        gl.bindBufferBase(gl.UNIFORM_BUFFER, slots.SLOT_FRAME, this.frameBuffer);

        this.site = slide.array('site') || new Float32Array(nx * ny);
        this.firstDepth = slide.array('d0');
        this.makeDetail();
        const field = (slot, format, filter, data) => this.texture(slots[slot], format, nx, ny, filter, data);
        field('SLOT_BEDROCK', gl.R32F, gl.NEAREST, slide.array('bed'));
        field('SLOT_SITE', gl.R8UI, gl.NEAREST, Uint8Array.from(this.site));
        this.fields = {
            depth: field('SLOT_DEPTH', gl.R32F, gl.NEAREST), rolling: field('SLOT_ROLLING', gl.R32F, gl.NEAREST),
            speed: field('SLOT_VELOCITY_X', gl.R32F, gl.NEAREST),
            firstDepth: field('SLOT_FIRST_DEPTH', gl.R32F, gl.NEAREST, this.firstDepth),
            firstDepthFiltered: field('SLOT_FIRST_DEPTH', gl.R16F, gl.LINEAR, this.firstDepth),
            openness: field('SLOT_OPENNESS', gl.R16F, gl.NEAREST),
            relief: field('SLOT_RELIEF', gl.RGBA32F, gl.NEAREST), filtered: field('SLOT_RELIEF', gl.RGBA16F, gl.LINEAR),
            layers: field('SLOT_LAYERS', gl.RGBA8, gl.LINEAR), measure: field('SLOT_MEASURE', gl.RG16F, gl.LINEAR),
            mixture: slide.info.two ? field('SLOT_MIXTURE', gl.RG8, gl.LINEAR) : null,
        };
        const [rays, rows] = slide.info.arrays.ceiling.size;
        this.texture(slots.SLOT_SUN_CEILING, gl.R32F, rays, rows, gl.NEAREST, slide.array('ceiling'));
        this.surfaceFrame = this.framebuffer([this.fields.relief, this.fields.filtered, this.fields.layers]);
        gl.viewport(0, 0, nx, ny);
        this.bind(slots.SLOT_OPENNESS, null);
        gl.bindFramebuffer(gl.FRAMEBUFFER, this.framebuffer([this.fields.openness]));
        this.fill(this.programs.openness);
        this.bind(slots.SLOT_OPENNESS, this.fields.openness);
        this.makeMesh();
        this.side = (Math.max(nx, ny) - 1) * slide.info.grid.dx;
        if (this.programs.debris) this.makeDebris();
        if (slide.info.surroundings) this.makeSurroundings();
        if (this.programs.built) this.makeBuilt();
        if (this.programs.treeNear) this.makeTrees();
        if (this.programs.puffs) this.makePowder();
    }

    // Small relief, as render/detail.cpp makes it.
    makeDetail() {
        const {gl, slots, programs} = this, size = kDetailSize, unit = slots.SLOT_DETAIL, halfway = Math.sqrt(size / 2), buffers = [];
        const target = (edge, count) => {
            const textures = Array.from({length: count}, () => this.texture(unit, gl.RGBA32F, edge, edge, gl.NEAREST));
            buffers.push(this.framebuffer(textures));
            gl.viewport(0, 0, edge, edge);
            this.bind(unit, null);
            return textures;
        };
        const heights = target(size, 1);
        programs.detailHeights.use();
        gl.uniform1f(programs.detailHeights.at('texels'), size);
        this.fill(programs.detailHeights);

        // The lowest and the highest, in two steps.
        let range = [heights[0], heights[0]];
        const ranges = [halfway, 1].map((edge, step) => {
            const next = target(edge, 2);
            this.bind(slots.SLOT_BEDROCK, range[0]);
            this.bind(slots.SLOT_DEPTH, range[1]);
            programs.detailRange.use();
            gl.uniform1i(programs.detailRange.at('edge'), step === 0 ? size / halfway : halfway);
            this.fill(programs.detailRange);
            return range = next;
        });

        const detail = gl.createTexture(), layerFrame = gl.createFramebuffer();
        gl.bindTexture(gl.TEXTURE_2D_ARRAY, detail);
        gl.texStorage3D(gl.TEXTURE_2D_ARRAY, Math.log2(size) + 1, gl.RGBA8, size, size, slots.DETAIL_LAYERS);
        this.bind(slots.SLOT_BEDROCK, range[0]);
        this.bind(slots.SLOT_DEPTH, range[1]);
        this.bind(unit, heights[0]);
        programs.detailLayer.use();
        gl.bindFramebuffer(gl.FRAMEBUFFER, layerFrame);
        gl.viewport(0, 0, size, size);
        for (let layer = 0; layer < slots.DETAIL_LAYERS; ++layer) {
            gl.framebufferTextureLayer(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT0, detail, 0, layer);
            gl.uniform1i(programs.detailLayer.at('layer'), layer);
            this.fill(programs.detailLayer);
        }
        for (const buffer of [...buffers, layerFrame]) gl.deleteFramebuffer(buffer);
        for (const texture of [...heights, ...ranges.flat()]) gl.deleteTexture(texture);
        gl.activeTexture(gl.TEXTURE0 + unit);
        gl.bindTexture(gl.TEXTURE_2D_ARRAY, detail);
        gl.generateMipmap(gl.TEXTURE_2D_ARRAY);
        gl.texParameteri(gl.TEXTURE_2D_ARRAY, gl.TEXTURE_MIN_FILTER, gl.LINEAR_MIPMAP_NEAREST);
    }

    // Its mean colour is that of the rolling layer.
    makeDebris() {
        const {gl, slots} = this, debris = new Debris(kDebrisOf[this.slide.info.texture]), size = kDebrisSize;
        gl.activeTexture(gl.TEXTURE0 + slots.SLOT_GRAIN);
        gl.bindTexture(gl.TEXTURE_2D, gl.createTexture());
        gl.texStorage2D(gl.TEXTURE_2D, Math.log2(size) + 1, gl.RGBA8, size, size);
        gl.texSubImage2D(gl.TEXTURE_2D, 0, 0, 0, size, size, gl.RGBA, gl.UNSIGNED_BYTE, debris.grain(slots.STEEPEST_GRAIN));
        gl.generateMipmap(gl.TEXTURE_2D);
        gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MIN_FILTER, gl.LINEAR_MIPMAP_NEAREST);
        this.texture(slots.SLOT_PAINT, gl.SRGB8_ALPHA8, 256, 1, gl.LINEAR, debris.colours());
        const mean = debris.meanColour();
        this.debrisTint = [...this.floats('rolling')].slice(0, 3).map((part, k) => part / mean[k]);
    }

    // Indices of the surface and of the walls of the block: render/ground_mesh.cpp.
    makeMesh() {
        const {gl, slots} = this, {nx, ny} = this.slide.info.grid, surface = [], walls = [];
        const ground = (x, y) => this.site[y * nx + x] !== slots.SITE_DRAIN;
        const inside = (x, y) => x >= 0 && y >= 0 && x + 1 < nx && y + 1 < ny;
        const isLower = (x, y) => inside(x, y) && ground(x, y) && ground(x + 1, y) && ground(x + 1, y + 1);
        const isUpper = (x, y) => inside(x, y) && ground(x, y) && ground(x + 1, y + 1) && ground(x, y + 1);
        const index = (x, y) => y << slots.INDEX_Y_SHIFT | x;
        const wall = (from, to) => walls.push(from | slots.INDEX_BASE, to | slots.INDEX_BASE, to, from | slots.INDEX_BASE, to, from);
        for (let y = 0; y + 1 < ny; ++y)
            for (let x = 0; x + 1 < nx; ++x) {
                const a = index(x, y), b = index(x + 1, y), c = index(x + 1, y + 1), d = index(x, y + 1);
                const lower = isLower(x, y), upper = isUpper(x, y);
                if (lower) surface.push(a, b, c);
                if (upper) surface.push(a, c, d);
                if (lower && !isUpper(x, y - 1)) wall(a, b);
                if (lower && !isUpper(x + 1, y)) wall(b, c);
                if (lower && !upper) wall(c, a);
                if (upper && !lower) wall(a, c);
                if (upper && !isLower(x, y + 1)) wall(c, d);
                if (upper && !isLower(x - 1, y)) wall(d, a);
            }
        this.surfaceMesh = this.mesh(Uint32Array.from(surface));
        if (this.programs.walls) this.wallMesh = this.mesh(Uint32Array.from(walls));
        this.rectangleArray = gl.createVertexArray();
        this.rectangleBuffer = gl.createBuffer();
        gl.bindVertexArray(this.rectangleArray);
        gl.bindBuffer(gl.ARRAY_BUFFER, this.rectangleBuffer);
        this.attribute(0, 4, 16, 0, 1);
    }

    // Triangles of vertices that need no attributes, or of those that `attributes` sets.
    mesh(indices, attributes = () => {}) {
        const {gl} = this, array = gl.createVertexArray();
        gl.bindVertexArray(array);
        gl.bindBuffer(gl.ELEMENT_ARRAY_BUFFER, gl.createBuffer());
        gl.bufferData(gl.ELEMENT_ARRAY_BUFFER, indices, gl.STATIC_DRAW);
        attributes();
        gl.bindVertexArray(null);
        return {array, count: indices.length};
    }

    attribute(location, parts, stride, offset, divisor = 0) {
        const {gl} = this;
        gl.enableVertexAttribArray(location);
        gl.vertexAttribPointer(location, parts, gl.FLOAT, false, stride, offset);
        gl.vertexAttribDivisor(location, divisor);
    }

    makeSurroundings() {
        const {gl, slide, slots} = this, {nx, ny} = slide.info.grid;
        const get = name => slide.array('around.' + name), x = get('x'), none = new Float32Array(x.length);
        const columns = [x, get('y'), get('z'), get('slope_x'), get('slope_y'), get('source_x'), get('source_y'), get('cover_d'),
                         get('cover_l') || none, get('open'), get('on'), get('sun')];
        const vertices = new Float32Array(columns.length * x.length);
        columns.forEach((column, k) => column.forEach((value, i) => vertices[columns.length * i + k] = value));
        this.aroundMesh = this.mesh(Uint32Array.from(get('index')), () => {
            gl.bindBuffer(gl.ARRAY_BUFFER, gl.createBuffer());
            gl.bufferData(gl.ARRAY_BUFFER, vertices, gl.STATIC_DRAW);
            [[3, 0], [4, 3], [4, 7], [1, 11]].forEach(([parts, first], i) => this.attribute(i, parts, 4 * columns.length, 4 * first));
        });

        // Mip-mapped, because a pixel of far mountains covers many vertices of the grid.
        const depth = slide.array('cover_d'), lower = slide.array('cover_l'), cover = new Float32Array(2 * nx * ny);
        depth.forEach((value, i) => cover.set([value, lower ? lower[i] : 0], 2 * i));
        gl.activeTexture(gl.TEXTURE0 + slots.SLOT_FIRST_COVER);
        gl.bindTexture(gl.TEXTURE_2D, gl.createTexture());
        gl.texStorage2D(gl.TEXTURE_2D, Math.floor(Math.log2(Math.max(nx, ny))) + 1, gl.RG16F, nx, ny);
        gl.texSubImage2D(gl.TEXTURE_2D, 0, 0, 0, nx, ny, gl.RG, gl.FLOAT, cover);
        gl.generateMipmap(gl.TEXTURE_2D);
        gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MIN_FILTER, gl.LINEAR_MIPMAP_NEAREST);
        for (const which of [gl.TEXTURE_WRAP_S, gl.TEXTURE_WRAP_T]) gl.texParameteri(gl.TEXTURE_2D, which, gl.CLAMP_TO_EDGE);
    }

    makeBuilt() {
        const {gl, slide} = this;
        this.built = {};
        for (const [table, names] of Object.entries(kBuiltColumns)) {
            const columns = names.map(name => slide.array(`${table}.${name}`)), width = columns.length;
            if (!columns[0]) continue;
            const vertices = new Float32Array(width * columns[0].length), array = gl.createVertexArray();
            columns.forEach((column, k) => column.forEach((value, i) => vertices[width * i + k] = value));
            gl.bindVertexArray(array);
            gl.bindBuffer(gl.ARRAY_BUFFER, gl.createBuffer());
            gl.bufferData(gl.ARRAY_BUFFER, vertices, gl.STATIC_DRAW);
            for (let i = 0; 4 * i < width; ++i) this.attribute(i, 4, 4 * width, 16 * i);
            const [first, count, from, until] = ['first', 'count', 'from', 'until'].map(name => slide.array(`${table}.${name}`));
            this.built[table] = {array, pieces: Array.from(first, (_, i) => ({first: first[i], count: count[i], from: from[i], until: until[i]}))};
        }
        gl.bindVertexArray(null);
    }

    makeTrees() {
        const {gl, slots} = this;
        this.trees = new TreesInView(this.slide, [...this.floats('sun')].slice(0, 3), slots);
        const rows = Math.ceil(this.trees.x.length / kTreesInARow);
        this.treeTexture = this.texture(slots.SLOT_UNITS, gl.RGBA32F, kTreeNumbers / 4 * kTreesInARow, rows, gl.NEAREST);
    }

    makePowder() {
        const {gl, slots} = this;
        this.powder = new PowderPuffs(this.slide, slots);
        this.powderBuffer = gl.createBuffer();
        gl.bindBuffer(gl.UNIFORM_BUFFER, this.powderBuffer);
        gl.bufferData(gl.UNIFORM_BUFFER, 8 * 16, gl.DYNAMIC_DRAW);
        gl.bindBufferBase(gl.UNIFORM_BUFFER, slots.SLOT_POWDER, this.powderBuffer);
        this.puffArray = gl.createVertexArray();
        this.puffBuffer = gl.createBuffer();
        gl.bindVertexArray(this.puffArray);
        gl.bindBuffer(gl.ARRAY_BUFFER, this.puffBuffer);
        for (const location of [0, 1, 2]) this.attribute(location, 4, 48, 16 * location, 1);
        gl.bindVertexArray(null);
        this.shadeTexture = this.texture(slots.SLOT_POWDER_SHADE, gl.RG32F, 64, 64, gl.NEAREST);
    }

    // ---- the target ----

    resize(width, height) {
        const {gl, slots, target} = this;
        if (width === target.width && height === target.height) return;
        for (const texture of target.textures || []) gl.deleteTexture(texture);
        for (const buffer of target.buffers || []) gl.deleteFramebuffer(buffer);
        if (target.marks) gl.deleteRenderbuffer(target.marks);
        const quarter = size => Math.ceil(size / 4), half = size => Math.ceil(size / kFinest);
        const depth = this.texture(slots.SLOT_SCENE_DEPTH, gl.DEPTH_COMPONENT32F, width, height, gl.NEAREST);
        const ground = this.texture(slots.SLOT_SCENE_DEPTH, gl.DEPTH_COMPONENT32F, width, height, gl.NEAREST);
        const colour = this.texture(slots.SLOT_COLOUR, gl.RGBA16F, width, height, gl.NEAREST);
        const sky = this.texture(slots.SLOT_SKY, gl.RGBA16F, quarter(width), quarter(height), gl.LINEAR);
        const stepped = this.texture(slots.SLOT_PICTURE, gl.RGBA8, width, height, gl.LINEAR);
        const smooth = this.texture(slots.SLOT_PICTURE, gl.RGBA8, width, height, gl.LINEAR);
        const textures = [depth, ground, colour, sky, stepped, smooth];
        const frames = {
            scene: this.framebuffer([colour], depth), ground: this.framebuffer([], ground), sky: this.framebuffer([sky]),
            air: this.framebuffer([colour]), stepped: this.framebuffer([stepped]), smooth: this.framebuffer([smooth]),
        };
        if (this.programs.debris) {
            const skin = ['SLOT_SKIN_ALBEDO', 'SLOT_SKIN_RELIEF'].map(slot => this.texture(slots[slot], gl.RGBA16F, width, height, gl.NEAREST));
            textures.push(...skin);
            target.skin = skin;
            frames.skin = this.framebuffer(skin);
        }
        const marks = gl.createRenderbuffer();
        gl.bindRenderbuffer(gl.RENDERBUFFER, marks);
        gl.renderbufferStorage(gl.RENDERBUFFER, gl.DEPTH24_STENCIL8, width, height);
        gl.framebufferRenderbuffer(gl.FRAMEBUFFER, gl.DEPTH_STENCIL_ATTACHMENT, gl.RENDERBUFFER, marks);
        if (this.powder) {
            const cloud = (slot, format, filter) => {
                textures.push(this.texture(slots[slot], format, half(width), half(height), filter));
                return textures[textures.length - 1];
            };
            const reach = cloud('SLOT_POWDER_REACH', gl.R32F, gl.NEAREST);
            const thick = cloud('SLOT_POWDER_THICK', gl.RGBA16F, gl.NEAREST), lower = cloud('SLOT_POWDER_LOWER', gl.R16F, gl.NEAREST);
            const lit = cloud('SLOT_POWDER_LIT', gl.RGBA16F, gl.LINEAR), hidden = cloud('SLOT_POWDER_HIDDEN', gl.RGBA32F, gl.NEAREST);
            Object.assign(frames, {reach: this.framebuffer([reach]), thick: this.framebuffer([thick, lower]), lit: this.framebuffer([lit, hidden])});
            target.cloud = {reach, thick, lower, lit, hidden};
        }
        this.columns = Math.ceil(width / kScreenTile);
        this.rows = Math.ceil(height / kScreenTile);
        Object.assign(target, {width, height, textures, marks, buffers: Object.values(frames), depth, ground, colour, sky, stepped, smooth, frames});
    }

    // ---- drawing ----

    // Draws the slide at its moment into the canvas. `overlay`: of slide.info.overlays, or null; `cursor`: a point of the
    // ground, or null. `scale`: samples per pixel of the screen along an edge.
    draw({view, overlay = null, cursor = null, scale = 1}) {
        const {gl} = this, width = gl.drawingBufferWidth, height = gl.drawingBufferHeight;
        if (gl.isContextLost()) return;
        this.resize(width, height);
        this.scale = scale;
        this.view = view;
        this.setFrame(overlay, cursor);
        this.frames = this.target.frames;
        this.began = performance.now();
        this.sendFields(overlay);
        this.mark('fields');
        this.drawDepth();
        this.mark('depth');
        this.tiles = this.slideTiles();
        if (this.programs.debris) this.drawDebris();
        this.mark('debris');
        this.shadeTerrain(overlay, cursor);
        this.mark('terrain');
        this.drawAround();
        this.mark('surroundings');
        const powdery = this.powder && !overlay && this.drawCloud();
        this.mark('powder');
        this.drawSky();
        this.mark('sky');
        if (this.built) this.drawBuilt();
        this.mark('structures');
        if (this.trees) this.drawTrees();
        this.mark('trees');
        if (powdery) this.layCloudOver();
        this.mark('powder over');
        this.show();
        this.mark('tone and edges');
        if (!this.prepared) this.prepared = setTimeout(() => this.prepareMarks());
    }

    // While passes are measured: waits for the last one and notes its time.
    mark(pass) {
        if (!this.passes) return;
        const {gl} = this;
        gl.bindFramebuffer(gl.FRAMEBUFFER, this.frames.stepped);
        gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, new Uint8Array(4));
        const now = performance.now();
        this.passes[pass] = (this.passes[pass] || 0) + now - this.began;
        this.began = now;
    }

    // One triangle that covers the target.
    fill(program) {
        const {gl} = this;
        program.use();
        gl.bindVertexArray(this.noVertices);
        gl.drawArrays(gl.TRIANGLES, 0, 3);
    }

    // Calls `draw` with some of WebGL's tests on; they are off everywhere else.
    enabled(switches, draw) {
        for (const each of switches) this.gl.enable(each);
        draw();
        for (const each of switches) this.gl.disable(each);
    }

    into(frame, width = this.target.width, height = this.target.height) {
        const {gl} = this;
        gl.bindFramebuffer(gl.FRAMEBUFFER, frame);
        gl.viewport(0, 0, width, height);
    }

    // Fields of the moment, and what the surface is there.
    sendFields(overlay) {
        const {gl, slide, slots, fields} = this, {nx, ny} = slide.info.grid;
        if (this.sentTick !== slide.tick) {
            this.sentTick = slide.tick;
            this.upload(slots.SLOT_DEPTH, fields.depth, nx, ny, slide.depth);
            this.upload(slots.SLOT_ROLLING, fields.rolling, nx, ny, slide.rolling);
            this.upload(slots.SLOT_VELOCITY_X, fields.speed, nx, ny, slide.speed);
            if (fields.mixture) this.upload(slots.SLOT_MIXTURE, fields.mixture, nx, ny, this.mixture());
            for (const slot of ['SLOT_RELIEF', 'SLOT_LAYERS']) this.bind(slots[slot], null);
            this.bind(slots.SLOT_FIRST_DEPTH, fields.firstDepth);
            this.into(this.surfaceFrame, nx, ny);
            this.fill(this.programs.surface);
            this.bind(slots.SLOT_LAYERS, fields.layers);
            this.bind(slots.SLOT_FIRST_DEPTH, fields.firstDepthFiltered);
            this.findSlides();
            this.sentOverlay = null;
        }
        if (overlay && overlay !== this.sentOverlay) this.upload(slots.SLOT_MEASURE, fields.measure, nx, ny, this.measure(overlay));
        this.sentOverlay = overlay;
    }

    // Two bytes per vertex.
    mixture() {
        const {lowerDepth, lowerRolling} = this.slide, bytes = new Uint8Array(2 * lowerDepth.length);
        lowerDepth.forEach((share, i) => bytes.set([Math.round(255 * share), Math.round(255 * lowerRolling[i])], 2 * i));
        return bytes;
    }

    // A legend whose values may lie on both sides of 0 is drawn by the numbers of its stops, because overlay.glsl begins
    // at 0.
    isTwoSided(overlay) { return overlay.stops[0][0] < 0; }

    legend(overlay) {
        return overlay.stops.flatMap(([value, red, green, blue], i) => [red, green, blue, this.isTwoSided(overlay) ? i + 1 : value]);
    }

    // The overlay's value times its weight, and the weight, of each vertex.
    measure(overlay) {
        const {slide} = this, visible = this.number('rolling', 3), stops = overlay.stops.map(stop => stop[0]);
        const thinnest = Math.min(...stops.map(Math.abs));
        const numbered = value => {
            const after = stops.findIndex(stop => stop >= value);
            if (after <= 0) return after < 0 ? stops.length : 1;
            return after + (value - stops[after - 1]) / (stops[after] - stops[after - 1]);
        };
        const of = {
            s: i => [slide.speed[i], slide.rolling[i]], R: i => [slide.rolling[i], slide.rolling[i]], d: i => [slide.depth[i], Infinity],
            peak_depth: i => [slide.peakDepth[i], slide.peakDepth[i]], peak_speed: i => [slide.peakSpeed[i], slide.peakDepth[i]],
            change: i => [slide.depth[i] - this.firstDepth[i], Infinity],
        }[overlay.field];
        const measured = new Float32Array(2 * slide.depth.length);
        for (let i = 0; i < slide.depth.length; ++i) {
            if (this.site[i] === this.slots.SITE_DRAIN) continue;
            const [value, depth] = of(i), twoSided = this.isTwoSided(overlay);
            const weight = twoSided ? Math.min(0.5 * Math.abs(value) / thinnest, 1) : Math.min(0.5 * depth / visible, 1);
            measured[2 * i] = weight * (twoSided ? numbered(value) : value);
            measured[2 * i + 1] = weight;
        }
        return measured;
    }

    drawDepth() {
        const {gl, slots, fields} = this;
        gl.depthFunc(gl.GEQUAL);
        gl.clearDepth(0.5);  // infinitely far away: window_depth.glsl
        this.bind(slots.SLOT_RELIEF, fields.relief);
        this.into(this.frames.scene);
        gl.clear(gl.DEPTH_BUFFER_BIT);
        gl.colorMask(false, false, false, false);
        this.enabled([gl.DEPTH_TEST, gl.CULL_FACE], () => this.drawMesh(this.programs.depth, this.surfaceMesh));
        gl.colorMask(true, true, true, true);
        this.keepDepth();
    }

    drawMesh(program, {array, count}) {
        const {gl} = this;
        program.use();
        gl.bindVertexArray(array);
        gl.drawElements(gl.TRIANGLES, count, gl.UNSIGNED_INT, 0);
    }

    // Copies the depth for shaders to read: they cannot read what is drawn into.
    keepDepth() {
        const {gl} = this, {width, height, frames, ground} = this.target;
        gl.bindFramebuffer(gl.READ_FRAMEBUFFER, frames.scene);
        gl.bindFramebuffer(gl.DRAW_FRAMEBUFFER, frames.ground);
        gl.blitFramebuffer(0, 0, width, height, 0, 0, width, height, gl.DEPTH_BUFFER_BIT, gl.NEAREST);
        this.bind(this.slots.SLOT_SCENE_DEPTH, ground);
        this.into(frames.scene);
    }

    drawRectangles(corners) {
        const {gl} = this;
        if (corners.length === 0) return;
        gl.bindVertexArray(this.rectangleArray);
        gl.bindBuffer(gl.ARRAY_BUFFER, this.rectangleBuffer);
        gl.bufferData(gl.ARRAY_BUFFER, Float32Array.from(corners), gl.STREAM_DRAW);
        gl.drawArraysInstanced(gl.TRIANGLES, 0, 6, corners.length / 4);
    }

    // Unlit, so that ground and debris are lit together.
    drawDebris() {
        const {gl, slots, slide} = this, {frames, skin} = this.target, {debris} = this.programs;
        this.bind(slots.SLOT_SKIN_ALBEDO, null);
        this.bind(slots.SLOT_SKIN_RELIEF, null);
        this.bind(slots.SLOT_RELIEF, this.fields.filtered);
        this.into(frames.skin);
        debris.use();
        gl.uniform1f(debris.at('seconds'), slide.tick * slide.info.tick_s);
        this.drawRectangles([...this.tiles[1], ...this.tiles[2]]);
        this.bind(slots.SLOT_SKIN_ALBEDO, skin[0]);
        this.bind(slots.SLOT_SKIN_RELIEF, skin[1]);
        this.into(frames.scene);
    }

    // Shades each pixel once.
    shadeTerrain(overlay, cursor) {
        const {gl, slots, fields} = this;
        const shading = overlay ? this.shading('marks.glsl', 'overlay.glsl')
            : cursor ? this.shading('marks.glsl', 'overlay_none.glsl') : this.shading('marks_none.glsl');
        this.bind(slots.SLOT_RELIEF, fields.filtered);
        gl.depthMask(false);
        gl.depthFunc(gl.LESS);
        this.enabled([gl.DEPTH_TEST], () => this.tiles.forEach((corners, kind) => {
            shading[kind].use();
            this.drawRectangles(corners);
        }));
        gl.depthFunc(gl.GEQUAL);
        gl.depthMask(true);
        this.bind(slots.SLOT_RELIEF, fields.relief);
    }

    // Finds the blocks of vertices near slides (1), and of those near walls where a slab broke off (2).
    findSlides() {
        const {slide, firstDepth} = this, {nx, ny} = slide.info.grid, {depth, rolling} = slide;
        this.blocksAcross = Math.ceil(nx / kSlideBlock);
        this.blocksUp = Math.ceil(ny / kSlideBlock);
        this.blocks = new Uint8Array(this.blocksAcross * this.blocksUp);
        const mark = (x, y, reach, kind) => {
            const block = (at, vertices) => Math.floor(clamp(at, 0, vertices - 1) / kSlideBlock);
            for (let j = block(y - reach, ny); j <= block(y + reach, ny); ++j)
                for (let i = block(x - reach, nx), at = j * this.blocksAcross + i; i <= block(x + reach, nx); ++i, ++at)
                    this.blocks[at] = Math.max(this.blocks[at], kind);
        };
        const change = i => depth[i] - firstDepth[i];
        const isUnderWall = (x, y) => {
            const here = change(y * nx + x);
            if (here > -0.09 || rolling[y * nx + x] > 0.3) return false;
            for (let j = Math.max(y - 1, 0); j <= Math.min(y + 1, ny - 1); ++j)
                for (let i = Math.max(x - 1, 0); i <= Math.min(x + 1, nx - 1); ++i)
                    if (change(j * nx + i) > Math.max(here + 0.09, -0.28)) return true;
            return false;
        };
        for (let y = 0, i = 0; y < ny; ++y)
            for (let x = 0; x < nx; ++x, ++i) {
                if (rolling[i] === 0 && depth[i] === firstDepth[i]) continue;
                mark(x, y, kSlideReach, 1);
                if (isUnderWall(x, y)) mark(x, y, kWallReach, 2);
            }
    }

    // Rectangles of the target that show no slide, slides, and walls: corners from −1 to 1, four numbers each.
    slideTiles() {
        const {nx, ny, dx} = this.slide.info.grid, {surface} = this.slide, {width, height} = this.target;
        const tiles = new Uint8Array(this.columns * this.rows);
        this.blocks.forEach((kind, number) => {
            if (kind === 0) return;
            const bx = number % this.blocksAcross, by = Math.floor(number / this.blocksAcross);
            const x0 = Math.max(bx * kSlideBlock - 1, 0), x1 = Math.min((bx + 1) * kSlideBlock, nx - 1);
            const y0 = Math.max(by * kSlideBlock - 1, 0), y1 = Math.min((by + 1) * kSlideBlock, ny - 1);
            let lowest = Infinity, highest = -Infinity;
            for (let y = y0; y <= y1; ++y)
                for (let x = x0; x <= x1; ++x) {
                    lowest = Math.min(lowest, surface[y * nx + x]);
                    highest = Math.max(highest, surface[y * nx + x]);
                }
            const seen = this.onScreen([x0 * dx, y0 * dx, lowest], [x1 * dx, y1 * dx, highest]);
            if (!seen) return;
            const [left, bottom, right, top] = seen.map(edge => Math.floor(edge / kScreenTile));
            for (let row = bottom; row <= Math.min(top, this.rows - 1); ++row)
                for (let column = left; column <= Math.min(right, this.columns - 1); ++column) {
                    const at = row * this.columns + column;
                    tiles[at] = Math.max(tiles[at], kind);
                }
        });
        const corners = [[], [], []];
        for (let row = 0; row < this.rows; ++row)
            for (let column = 0, end; column < this.columns; column = end) {
                const kind = tiles[row * this.columns + column];
                for (end = column + 1; end < this.columns && tiles[row * this.columns + end] === kind;) ++end;
                corners[kind].push(2 * column * kScreenTile / width - 1, 2 * row * kScreenTile / height - 1,
                                   2 * Math.min(end * kScreenTile, width) / width - 1, 2 * Math.min((row + 1) * kScreenTile, height) / height - 1);
            }
        return corners;
    }

    // The part of the target that a box may cover: left, bottom, right, top in samples; null if none.
    onScreen(low, high) {
        const {clip, near} = this.view, {width, height} = this.target;
        const beyond = [0, 0, 0, 0], samples = [Infinity, Infinity, -Infinity, -Infinity];
        let behind = 0;
        for (let corner = 0; corner < 8; ++corner) {
            const at = [0, 1, 2].map(k => corner >> k & 1 ? high[k] : low[k]);
            const [x, y, w] = [0, 1, 3].map(row => clip[row] * at[0] + clip[4 + row] * at[1] + clip[8 + row] * at[2] + clip[12 + row]);
            beyond[0] += x < -w, beyond[1] += x > w, beyond[2] += y < -w, beyond[3] += y > w;
            if (w < near) {
                ++behind;
                continue;
            }
            const place = [(0.5 + 0.5 * clamp(x / w, -2, 2)) * width, (0.5 + 0.5 * clamp(y / w, -2, 2)) * height];
            place.forEach((sample, k) => {
                samples[k] = Math.min(samples[k], sample - 1);
                samples[2 + k] = Math.max(samples[2 + k], sample + 2);
            });
        }
        if (behind === 8 || beyond.includes(8)) return null;
        if (behind > 0) return [0, 0, width, height];
        const part = [Math.max(samples[0], 0), Math.max(samples[1], 0), Math.min(samples[2], width), Math.min(samples[3], height)];
        return part[0] < part[2] && part[1] < part[3] ? part : null;
    }

    // Mountains, or the walls of a block.
    drawAround() {
        const {gl} = this;
        this.enabled([gl.DEPTH_TEST, gl.CULL_FACE], () => {
            if (this.aroundMesh) this.drawMesh(this.programs.around, this.aroundMesh);
            else this.drawMesh(this.programs.walls, this.wallMesh);
        });
        this.keepDepth();
    }

    // The sky is smooth, so that a sixteenth of its pixels are enough; sun, moon and stars are not.
    drawSky() {
        const {gl} = this, {width, height, frames, sky} = this.target;
        this.bind(this.slots.SLOT_SKY, null);
        this.into(frames.sky, Math.ceil(width / 4), Math.ceil(height / 4));
        this.fill(this.programs.sky);
        this.bind(this.slots.SLOT_SKY, sky);
        this.into(frames.scene);
        this.enabled([gl.DEPTH_TEST], () => this.fill(this.programs.lights));
    }

    // What people have built, as it is in the stored frame before the moment.
    drawBuilt() {
        const {gl, slide, programs} = this, frame = Math.min(Math.floor(slide.tick / slide.info.every), slide.info.frames - 1);
        const draw = table => {
            if (!this.built[table]) return;
            const {array, pieces} = this.built[table];
            programs[table].use();
            gl.bindVertexArray(array);
            for (const {first, count, from, until} of pieces) if (from <= frame && frame < until) gl.drawArrays(gl.TRIANGLES, first, count);
        };
        this.enabled([gl.DEPTH_TEST], () => {
            draw('built');
            gl.depthMask(false);
            // A shadow lies on the ground as triangles, which are a little above it everywhere.
            gl.polygonOffset(2, 8);
            gl.blendFunc(gl.ZERO, gl.SRC_COLOR);
            this.enabled([gl.BLEND, gl.POLYGON_OFFSET_FILL], () => draw('shadows'));
            gl.blendFunc(gl.SRC_ALPHA, gl.ONE_MINUS_SRC_ALPHA);
            this.enabled([gl.BLEND], () => draw('ropes'));
            gl.depthMask(true);
        });
    }

    drawTrees() {
        const {gl, slots, trees} = this, key = [...this.view.clip, this.target.width, this.scale].join();
        if (key !== this.treesKey) trees.find({...this.view, pixel: this.view.pixel * Math.max(this.scale, 1)}, (low, high) => this.onScreen(low, high));
        if (key !== this.treesKey || this.treesTick !== this.slide.tick) {
            const rows = trees.settle(), width = kTreeNumbers / 4 * kTreesInARow;
            if (rows > 0) this.upload(slots.SLOT_UNITS, this.treeTexture, width, rows, trees.drawn.subarray(0, 4 * width * rows));
        }
        this.treesKey = key;
        this.treesTick = this.slide.tick;
        gl.bindVertexArray(this.noVertices);
        const draw = (program, vertices, first, count) => {
            if (count === 0) return;
            program.use();
            gl.drawArrays(gl.TRIANGLES, vertices * first, vertices * count);
        };
        const {near, far, withShadow} = trees, {treeShadow, treeNear, treeFar, treePlain} = this.programs;
        this.enabled([gl.DEPTH_TEST], () => {
            // A shadow lies on the ground as a triangle, which is a little above it everywhere.
            gl.depthMask(false);
            gl.blendFunc(gl.ZERO, gl.SRC_COLOR);
            gl.polygonOffset(2, 8);
            this.enabled([gl.BLEND, gl.POLYGON_OFFSET_FILL], () => draw(treeShadow, 3, 0, withShadow));
            gl.depthMask(true);
            draw(treeNear, 3 * (slots.TREE_TIERS * slots.TREE_SIDES + 3), 0, near);  // TREE_VERTICES
            draw(treeFar, 3, near, far);
            draw(treePlain, 3, near + far, trees.standing.length - near - far);
        });
    }

    // The powder in coarse pixels of its own. Returns whether there is any.
    drawCloud() {
        const {gl, slots, slide, powder} = this, {width, height, frames, cloud} = this.target, sun = [...this.floats('sun')].slice(0, 3);
        if (!powder.find(slide.tick, this.view, sun)) return false;
        const samples = width * height, tooMany = powder.covered * samples / (kLeastBudget + kBudgetPerSample * samples);
        const divisor = tooMany > kFinest * kFinest ? kCoarsest : kFinest;
        const wide = Math.ceil(width / divisor), high = Math.ceil(height / divisor);
        this.sendPowder(divisor);
        for (const name of Object.keys(cloud)) this.bind(slots['SLOT_POWDER_' + name.toUpperCase()], null);
        const box = this.boxOf(powder.box, wide, high, 3);
        gl.scissor(...box);
        this.enabled([gl.SCISSOR_TEST], () => {
            this.into(frames.reach, wide, high);
            this.fill(this.programs.reach);
            this.bind(slots.SLOT_POWDER_REACH, cloud.reach);
            this.into(frames.thick, wide, high);
            for (const target of [0, 1]) gl.clearBufferfv(gl.COLOR, target, [0, 0, 0, 0]);
            gl.blendFunc(gl.ONE, gl.ONE_MINUS_SRC_ALPHA);
            this.enabled([gl.BLEND], () => {
                this.programs.puffs.use();
                gl.bindVertexArray(this.puffArray);
                gl.drawArraysInstanced(gl.TRIANGLES, 0, 6, powder.count);
            });
            this.bind(slots.SLOT_POWDER_THICK, cloud.thick);
            this.bind(slots.SLOT_POWDER_LOWER, cloud.lower);
            this.into(frames.lit, wide, high);
            this.fill(this.programs.cloudLight);
            this.bind(slots.SLOT_POWDER_LIT, cloud.lit);
            this.bind(slots.SLOT_POWDER_HIDDEN, cloud.hidden);
        });
        return true;
    }

    // Left, bottom, width and height of a box from −1 to 1, in pixels, and `rim` more.
    boxOf([left, bottom, right, top], width, height, rim) {
        const pixel = (at, size) => Math.floor((0.5 + 0.5 * at) * size);
        const x = pixel(left, width) - rim, y = pixel(bottom, height) - rim;
        return [x, y, pixel(right, width) + rim + 1 - x, pixel(top, height) + rim + 1 - y];
    }

    sendPowder(divisor) {
        const {gl, slide, slots, powder, target} = this, {info} = slide;
        const block = new ArrayBuffer(8 * 16), put = (i, numbers) => new Float32Array(block, 16 * i).set(numbers);
        const across = target.width / divisor, up = target.height / divisor;
        const texel = [1 / Math.ceil(target.width / kFinest), 1 / Math.ceil(target.height / kFinest)];
        const lamp = this.floats('lamp'), above = this.floats('above'), height = this.number('sun', 2);
        const lost = [0, 1, 2].map(k => lamp[k] * height / (lamp[k] * height + above[k]));
        put(0, [...info.powder.colour, powder.meanRadius]);
        put(1, [...(info.lower_powder || info.powder).colour, powder.mixed ? 1 : 0]);
        put(2, powder.shade.across);
        put(3, powder.shade.up);
        new Int32Array(block, 64, 4).fill(divisor);
        put(5, [across, up, 1 / divisor, 0]);
        put(6, [...texel, (Math.ceil(across) - 0.5) * texel[0], (Math.ceil(up) - 0.5) * texel[1]]);
        put(7, [...lost.map(share => lost[0] - share), lost[0]]);
        gl.bindBuffer(gl.UNIFORM_BUFFER, this.powderBuffer);
        gl.bufferSubData(gl.UNIFORM_BUFFER, 0, block);
        gl.bindBuffer(gl.UNIFORM_BUFFER, this.frameBuffer);
        gl.bindBuffer(gl.ARRAY_BUFFER, this.puffBuffer);
        gl.bufferData(gl.ARRAY_BUFFER, powder.drawn.subarray(0, kPuffNumbers * powder.count), gl.STREAM_DRAW);
        this.upload(slots.SLOT_POWDER_SHADE, this.shadeTexture, 64, 64, powder.shade.cells);
    }

    // First it takes light from the frame, then it adds its own: WebGL has no blending of two colours.
    layCloudOver() {
        const {gl} = this, {width, height, frames, depth} = this.target;
        this.into(frames.air);
        this.bind(this.slots.SLOT_SCENE_DEPTH, depth);
        gl.scissor(...this.boxOf(this.powder.box, width, height, 1));
        this.enabled([gl.SCISSOR_TEST, gl.BLEND], () => {
            gl.blendFunc(gl.ZERO, gl.ONE_MINUS_SRC_COLOR);
            this.fill(this.programs.overTaken);
            gl.blendFunc(gl.ONE, gl.ONE);
            this.fill(this.programs.overAdded);
        });
    }

    // Maps light to what a screen shows, and draws that on the canvas: Chromium does not see what is blitted there.
    show() {
        const {slots} = this, {frames, colour, stepped, smooth} = this.target;
        this.bind(slots.SLOT_COLOUR, colour);
        this.bind(slots.SLOT_PICTURE, null);
        this.into(frames.stepped);
        this.fill(this.programs.tone);
        if (this.scale === 1) this.smoothEdges();
        this.bind(slots.SLOT_PICTURE, this.scale === 1 ? smooth : stepped);
        this.into(null);
        this.fill(this.programs.copied);
    }

    // Of a picture with one sample per pixel.
    smoothEdges() {
        const {gl, slots} = this, {width, height, frames, stepped} = this.target;
        gl.bindFramebuffer(gl.READ_FRAMEBUFFER, frames.stepped);
        gl.bindFramebuffer(gl.DRAW_FRAMEBUFFER, frames.smooth);
        gl.blitFramebuffer(0, 0, width, height, 0, 0, width, height, gl.COLOR_BUFFER_BIT, gl.NEAREST);
        this.bind(slots.SLOT_PICTURE, stepped);
        this.into(frames.smooth);
        gl.clear(gl.STENCIL_BUFFER_BIT);
        this.enabled([gl.STENCIL_TEST], () => {
            gl.stencilFunc(gl.ALWAYS, 1, 0xff);
            gl.stencilOp(gl.KEEP, gl.KEEP, gl.REPLACE);
            gl.colorMask(false, false, false, false);
            this.fill(this.programs.edgeMarks);
            gl.colorMask(true, true, true, true);
            gl.stencilOp(gl.KEEP, gl.KEEP, gl.KEEP);
            gl.stencilFunc(gl.EQUAL, 1, 0xff);
            this.fill(this.programs.edges);
        });
    }

    // ---- for tests ----

    // The bytes of the last picture, from its lowest row on: call it right after draw().
    pixels() {
        const {gl} = this, {width, height, frames} = this.target, bytes = new Uint8Array(4 * width * height);
        gl.bindFramebuffer(gl.FRAMEBUFFER, this.scale === 1 ? frames.smooth : frames.stepped);
        gl.readPixels(0, 0, width, height, gl.RGBA, gl.UNSIGNED_BYTE, bytes);
        return {width, height, p: bytes};
    }

    // Mean ms of each pass and of all, over some pictures of what draw() takes.
    time(input, count) {
        this.passes = {};
        for (let i = 0; i < count; ++i) {
            this.sentTick = this.treesKey = null;
            this.draw(input);
        }
        const times = Object.fromEntries(Object.entries(this.passes).map(([pass, ms]) => [pass, ms / count]));
        this.passes = null;
        return {...times, all: Object.values(times).reduce((a, b) => a + b, 0)};
    }
}
