// The picture: draws a slide at its moment with the program's own shaders, in the order of render/frame.cpp.
const kDebrisTiles = 9;  // along the longer side
const kFlowOffset = [1, 64];  // by slope, and steps of depth: the flow lies on other triangles of the same heights

class Picture {
    // Throws an error whose message is a sentence for the viewer.
    static async create(canvas, slide) {
        const gl = canvas.getContext('webgl2', {antialias: false, depth: false, alpha: false,
                                                powerPreference: 'high-performance'});
        if (!gl)
            throw new Error('This browser cannot draw WebGL 2. ' +
                            'Try another browser, or allow graphics acceleration in its settings.');
        if (!gl.getExtension('EXT_color_buffer_float'))
            throw new Error('This graphics card cannot draw into textures of floating-point numbers, ' +
                            'which this page needs. Try another device.');
        const picture = new Picture(gl, slide);
        picture.compile();
        await picture.shaders.ready();
        picture.make();
        return picture;
    }

    constructor(gl, slide) {
        this.gl = gl;
        this.slide = slide;
        this.gpu = new Gpu(gl);
        this.shaders = new Shaders(gl, name => slide.file(name));
        this.slots = this.shaders.constants;
        this.frame = new FrameBlock(this.gpu, slide, this.slots);
        // Firefox gives the name itself, and warns of the extension by which others do.
        const name = gl.getParameter(gl.RENDERER);
        const others = /^WebKit/.test(name) && gl.getExtension('WEBGL_debug_renderer_info');
        this.renderer = others ? gl.getParameter(others.UNMASKED_RENDERER_WEBGL) : name;
        this.target = {width: 0, height: 0, textures: [], frames: {}};
        this.passes = null;  // ms by name while they are measured
    }

    // ---- shaders ----

    // Each has the files that the program's pass joins, and the page's own where WebGL 2 is less.
    compile() {
        const {info} = this.slide, fullscreen = ['fullscreen.vert'];
        const frame = ['slots.glsl', 'frame.glsl'], light = [...frame, 'light.glsl'];
        const lit = [...light, 'sun_ceiling.glsl'];
        const add = (vertex, fragment, out) => this.shaders.add(vertex, fragment, out);
        const stars = this.frame.floats('above')[3] > 0 ? 'stars.glsl' : 'stars_none.glsl';
        const dated = this.dated = this.frame.floats('season')[3] > 0 ? 'dated.glsl' : 'undated.glsl';
        const turf = dated === 'dated.glsl' ? 'turf.glsl' : 'turf_none.glsl';
        this.programs = {
            openness: add(fullscreen, [...frame, 'openness.glsl', 'openness.frag']),
            surface: add(fullscreen, [...frame, 'cover.glsl', 'surface.glsl', 'surface.frag']),
            detailHeights: add(fullscreen, ['slots.glsl', 'detail_heights.frag']),
            detailRange: add(fullscreen, ['slots.glsl', 'detail_range.frag']),
            detailLayer: add(fullscreen, ['slots.glsl', 'detail_layer.frag']),
            depth: add([...frame, 'terrain.vert'], ['depth.frag']),
            sky: add(fullscreen, [...light, 'sky.frag']),
            lights: add(fullscreen, [...frame, 'sky_lights.frag', stars]),
            tone: add(fullscreen, ['slots.glsl', 'tone_curve.glsl', 'encoded_before.glsl', 'tone.frag',
                                   'encoded.frag']),
            copied: add(fullscreen, ['slots.glsl', 'copied.frag']),
            edgeMarks: add(fullscreen, ['slots.glsl', 'gather.glsl', 'edges_mark.frag']),
            edges: add(fullscreen, ['slots.glsl', 'gather.glsl', 'edges.frag']),
        };
        this.shadings = new Map();
        this.shading('marks_none.glsl');
        if (info.texture)
            this.programs.debris = add(['rectangles.vert'], [...frame, 'window_depth.glsl', 'debris.frag', 'grain.glsl',
                                                             'paint_blended.glsl']);
        if (info.texture && info.live)
            this.programs.flow = add([...frame, 'triangle_height.glsl', 'flow_live.vert'],
                                     [...frame, 'flow.frag', 'grain.glsl', turf, 'paint_blended.glsl']);
        if (info.surroundings)
            this.programs.around = add([...frame, 'cover.glsl', 'surroundings.vert'],
                                       [...frame, dated, 'cover.glsl', 'light.glsl', 'ground.glsl', 'plants.glsl', 'surroundings.frag',
                                        info.two ? 'surroundings_two.glsl' : 'surroundings_one.glsl']);
        else
            this.programs.walls = add([...frame, 'terrain.vert'], [...lit, 'gather.glsl', 'walls.frag']);
        if (info.arrays['built.x'] || info.live)
            Object.assign(this.programs, {
                built: add([...lit, 'triangle_height.glsl', 'structure.vert'], [...frame, 'structure.frag']),
                ropes: add([...lit, 'rope.vert'], ['rope.frag']),
                shadows: add([...lit, 'triangle_height.glsl', 'structure_shadow.vert'], ['structure_shadow.frag']),
            });
        const trees = [...light, 'tree.glsl', 'tree_texture.glsl'];
        if (info.arrays['trees.pictures'])
            Object.assign(this.programs, {
                treeShadow: add([...trees, 'tree_shadow.vert'], ['slots.glsl', 'tree_covered.glsl', 'tree_shadow.frag']),
                tree: add([...trees, 'tree_picture.vert'], ['slots.glsl', dated, 'tree_covered.glsl', 'tree_picture.frag']),
            });
        if (info.arrays['ridges.x'])
            this.programs.spindrift = add([...light, 'spindrift.vert'],
                                          [...frame, 'window_depth.glsl', 'spindrift.frag']);
        const powder = [...frame, 'powder.glsl'], over = [...powder, 'window_depth.glsl', 'powder_over.frag'];
        const powdery = info.powder.strength > 0 || info.lower_powder.strength > 0;
        if (info.arrays['puffs.x'] || (info.live && powdery))
            Object.assign(this.programs, {
                reach: add(fullscreen, [...powder, 'window_depth.glsl', 'powder_reach.frag']),
                puffs: add([...frame, 'sun_ceiling.glsl', 'powder.glsl', 'powder.vert'], [...powder, 'powder.frag']),
                cloudLight: add(fullscreen, [...lit, 'powder.glsl', 'powder_light.frag']),
                overAdded: add(fullscreen, over, 0), overTaken: add(fullscreen, over, 1),
            });
    }

    // The terrain's shaders with some marks: where there is no slide, where one is or was, and where a slab broke off or ground
    // was sculpted.
    shading(...marks) {
        const earth = this.slide.earth ? 'earth.glsl' : 'earth_none.glsl', key = [earth, ...marks].join();
        if (!this.shadings.has(key)) {
            const files = ['slots.glsl', 'frame.glsl', this.dated, 'light.glsl', 'sun_ceiling.glsl', 'ground.glsl',
                           'plants.glsl', 'tone_curve.glsl', 'spline.glsl', 'window_depth.glsl', 'surface_place.glsl', 'terrain.frag', 'wet_none.glsl',
                           this.slide.info.two ? 'materials_two.glsl' : 'materials_one.glsl'];
            const kinds = [['earth_none.glsl', 'slides_none.glsl', 'crown_none.glsl'],
                           ['earth_none.glsl', 'slides.glsl', 'crown_none.glsl'], [earth, 'slides.glsl', 'crown.glsl']];
            const add = kind => this.shaders.add(['rectangles.vert'], [...files, ...kind, ...marks]);
            this.shadings.set(key, kinds.map(add));
        }
        return this.shadings.get(key);
    }

    // Begins to compile what is needed once a legend or a point is chosen.
    prepareMarks() {
        if (this.gl.isContextLost()) return;
        for (const overlay of ['overlay.glsl', 'overlay_none.glsl']) this.shading('marks.glsl', overlay);
    }

    // ---- what is made once ----

    make() {
        const {gl, gpu, slide, slots, programs, frame} = this, {nx, ny, dx} = slide.info.grid;
        makeSmallRelief(gpu, programs, slots);
        this.site = slide.array('site') ?? new Float32Array(nx * ny);
        this.firstDepth = slide.array('d0');
        const field = (slot, format, filter, data) => gpu.texture(slots[slot], format, nx, ny, filter, data);
        field('SLOT_SITE', gl.R8UI, gl.NEAREST, Uint8Array.from(this.site));
        this.fields = {
            bed: field('SLOT_BEDROCK', gl.R32F, gl.NEAREST, slide.bed),
            depth: field('SLOT_DEPTH', gl.R32F, gl.NEAREST), rolling: field('SLOT_ROLLING', gl.R32F, gl.NEAREST),
            speed: field('SLOT_VELOCITY_X', gl.R32F, gl.NEAREST),
            // 32-bit floats for heights, 16-bit ones for what is filtered: not every device can filter the former.
            firstDepth: field('SLOT_UNDISTURBED', gl.R32F, gl.NEAREST, this.firstDepth),
            firstDepthFiltered: field('SLOT_UNDISTURBED', gl.R16F, gl.LINEAR, this.firstDepth),
            openness: field('SLOT_OPENNESS', gl.R16F, gl.NEAREST),
            relief: field('SLOT_RELIEF', gl.RGBA32F, gl.NEAREST), filtered: field('SLOT_RELIEF', gl.RGBA16F, gl.LINEAR),
            layers: field('SLOT_LAYERS', gl.RGBA8, gl.LINEAR), measure: field('SLOT_MEASURE', gl.RG16F, gl.LINEAR),
            extent: slide.info.goal?.ghost_step === undefined ? null : field('SLOT_EXTENT', gl.R16F, gl.LINEAR),
            land: this.landTexture(),
            mixture: slide.info.two ? field('SLOT_MIXTURE', gl.RG8, gl.LINEAR) : null,
        };
        this.surface = gpu.target([this.fields.relief, this.fields.filtered, this.fields.layers]);
        const [rays, rows] = slide.info.arrays.ceiling.size;
        gpu.texture(slots.SLOT_SUN_CEILING, gl.R32F, rays, rows, gl.NEAREST, slide.array('ceiling'));
        gpu.into(gpu.target([this.fields.openness]), nx, ny);
        gpu.bind(slots.SLOT_OPENNESS, null);
        gpu.fill(programs.openness);
        gpu.bind(slots.SLOT_OPENNESS, this.fields.openness);

        frame.floats('flow').fill(0);
        if (programs.debris) this.makeDebris(kDebrisTiles / ((Math.max(nx, ny) - 1) * dx));
        if (slide.earth) this.earthTexture();
        this.makeMesh();
        this.tiles = new SlideTiles(slide, this.firstDepth);
        this.scenery = new Scenery(gpu, slide, programs, slots, frame);
        this.cloud = programs.puffs ? new Cloud(gpu, slide, programs, slots, frame) : null;
    }

    // What plants and water find on the ground; nothing without a date.
    landTexture() {
        const {gl, gpu, slide, slots} = this;
        const parts = ['brook', 'moisture', 'use', 'rubble'].map(part => slide.array('land.' + part));
        const [width, height] = slide.info.arrays['land.brook']?.size ?? [1, 1], texels = new Uint8Array(4 * width * height);
        parts.forEach((part, channel) => part?.forEach((share, i) => texels[4 * i + channel] = share));
        return gpu.texture(slots.SLOT_LAND, gl.RGBA8, width, height, gl.LINEAR, texels);
    }

    // Its mean colour is that of the rolling layer.
    makeDebris(tilesPerMetre) {
        const {gl, gpu, slots, frame} = this, debris = new Debris(kDebrisOf[this.slide.info.texture]);
        gpu.mipMapped(slots.SLOT_GRAIN, gl.RGBA8, kDebrisSize, kDebrisSize, debris.grain(slots.STEEPEST_GRAIN));
        gpu.texture(slots.SLOT_PAINT, gl.SRGB8_ALPHA8, 256, 1, gl.LINEAR, debris.colours());
        const mean = debris.meanColour();
        frame.floats('flow').set([tilesPerMetre, slots.FLOW_ROLLING]);
        frame.floats('flow_tint').set([...frame.floats('rolling', 3)].map((part, k) => part / mean[k]));
    }

    // Indices of the surface and of the walls of the block: render/mountain/ground_mesh.cpp.
    makeMesh() {
        const {gpu, slots} = this, {nx, ny} = this.slide.info.grid, surface = [], walls = [];
        const ground = (x, y) => this.site[y * nx + x] !== slots.SITE_DRAIN;
        const inside = (x, y) => x >= 0 && y >= 0 && x + 1 < nx && y + 1 < ny;
        const isLower = (x, y) => inside(x, y) && ground(x, y) && ground(x + 1, y) && ground(x + 1, y + 1);
        const isUpper = (x, y) => inside(x, y) && ground(x, y) && ground(x + 1, y + 1) && ground(x, y + 1);
        const index = (x, y) => y << slots.INDEX_Y_SHIFT | x, base = at => at | slots.INDEX_BASE;
        const wall = (from, to) => walls.push(base(from), base(to), to, base(from), to, from);
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
        this.surfaceMesh = gpu.mesh(Uint32Array.from(surface));
        this.wallMesh = gpu.mesh(Uint32Array.from(walls));
    }

    // ---- the target ----

    // `isSmoothed`: it has room to smooth edges.
    resize(width, height, isSmoothed) {
        const {gl, gpu, slots, target} = this;
        if (width === target.width && height === target.height && isSmoothed === target.isSmoothed) return;
        for (const texture of target.textures) gl.deleteTexture(texture);
        for (const frame of Object.values(target.frames)) gl.deleteFramebuffer(frame);
        gl.deleteRenderbuffer(target.marks ?? null);
        const quarter = size => Math.ceil(size / 4);
        const make = (slot, format, filter = gl.NEAREST) => gpu.texture(slots[slot], format, width, height, filter);
        const [depth, ground] = [0, 1].map(() => make('SLOT_SCENE_DEPTH', gl.DEPTH_COMPONENT32F));
        const colour = make('SLOT_COLOUR', gl.RGBA16F);
        const sky = gpu.texture(slots.SLOT_SKY, gl.RGBA16F, quarter(width), quarter(height), gl.LINEAR);
        const skins = this.programs.debris ? ['SLOT_SKIN_ALBEDO', 'SLOT_SKIN_RELIEF'] : [];
        const skin = skins.map(slot => make(slot, gl.RGBA16F));
        const frames = {scene: gpu.target([colour], depth), ground: gpu.target([], ground), sky: gpu.target([sky]),
                        air: gpu.target([colour]), skin: gpu.target(skin), flow: gpu.target(skin, depth)};
        this.target = {width, height, isSmoothed, depth, ground, colour, sky, skin, frames,
                       textures: [depth, ground, colour, sky, ...skin]};
        if (isSmoothed) this.addSmoothing();
        if (this.cloud) this.cloud.resize(width, height);
    }

    addSmoothing() {
        const {gl, gpu, slots, target, target: {width, height}} = this;
        for (const name of ['stepped', 'smooth']) {
            target[name] = gpu.texture(slots.SLOT_PICTURE, gl.RGBA8, width, height, gl.LINEAR);
            target.frames[name] = gpu.target([target[name]]);
            target.textures.push(target[name]);
        }
        target.marks = gl.createRenderbuffer();
        gl.bindRenderbuffer(gl.RENDERBUFFER, target.marks);
        gl.renderbufferStorage(gl.RENDERBUFFER, gl.DEPTH_COMPONENT16, width, height);
        gl.framebufferRenderbuffer(gl.FRAMEBUFFER, gl.DEPTH_ATTACHMENT, gl.RENDERBUFFER, target.marks);
    }

    into(frame) {
        this.gpu.into(this.target.frames[frame], this.target.width, this.target.height);
    }

    // ---- drawing ----

    // Draws the slide at its moment into the canvas. `overlay`: of slide.info.overlays, or null; `cursor`: a point of
    // the ground with the radius and colour of a ring around it, or null. `scale`: samples per pixel of the screen along
    // an edge.
    draw({view, overlay = null, cursor = null, scale = 1}) {
        const {gl, frame, scenery, cloud} = this;
        if (gl.isContextLost()) return;
        this.began = performance.now();
        this.resize(gl.drawingBufferWidth, gl.drawingBufferHeight, scale === 1);  // one sample per pixel has stairs
        // A larger scale has more samples, not more trees.
        const samples = Math.max(scale, 1), onScreen = (low, high) => this.onScreen(view, low, high);
        frame.setView(view, samples);
        frame.setOverlay(overlay, overlay && this.legend(overlay));
        frame.setRing(cursor);
        frame.setExtent(this.slide.extent);
        frame.send();
        this.sendFields(overlay);
        this.mark('fields');
        this.drawDepth();
        this.mark('depth');

        // Debris is drawn unlit, so that ground and debris are lit together, once per pixel.
        const rectangles = this.tiles.rectangles(this.target.width, this.target.height, onScreen);
        if (this.programs.flow && this.slide.flow) this.drawFlow();
        else if (this.programs.debris) this.drawDebris(rectangles);
        this.mark('debris');
        this.shadeTerrain(rectangles, overlay, cursor);
        this.mark('terrain');
        if (scenery.mountains) scenery.drawMountains();
        else this.drawWalls();
        this.mark('surroundings');

        // The cloud must know how far the ground is behind it, not the trees in front: their outlines are finer.
        this.keepDepth();
        const powdery = cloud && !overlay && cloud.draw(view);
        this.mark('powder');
        this.drawSky();
        this.mark('sky');
        scenery.drawBuilt();
        this.mark('structures');
        scenery.drawTrees({...view, pixel: view.pixel * samples}, onScreen);
        this.mark('trees');
        // What floats in the air lies over everything that is not nearer.
        if (powdery || scenery.ridges) this.beginAir();
        if (scenery.ridges && !overlay) scenery.drawSpindrift();
        if (powdery) cloud.layOver();
        this.mark('air');
        this.show();
        this.mark('tone and edges');
        if (!this.prepared) this.prepared = setTimeout(() => this.prepareMarks());
    }

    // While passes are measured: waits for the last one and notes its time.
    mark(pass) {
        if (!this.passes) return;
        const {gl} = this;
        gl.bindFramebuffer(gl.FRAMEBUFFER, null);
        gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, new Uint8Array(4));
        const now = performance.now();
        this.passes[pass] = (this.passes[pass] ?? 0) + now - this.began;
        this.began = now;
        this.into('scene');
    }

    // Fields of the moment, and what the surface is there.
    sendFields(overlay) {
        const {gpu, slide, slots, fields} = this, {nx, ny} = slide.info.grid;
        if (this.sentVersion !== slide.version) {
            if (slide.bedVersion > (this.sentVersion ?? 0)) {
                gpu.upload(slots.SLOT_BEDROCK, fields.bed, nx, ny, slide.bed);
                if (slide.earth) gpu.upload(slots.SLOT_EARTH, this.earthTexture(), nx, ny, slide.earth);
            }
            this.sentVersion = slide.version;
            this.sentOverlay = null;
            gpu.upload(slots.SLOT_DEPTH, fields.depth, nx, ny, slide.depth);
            gpu.upload(slots.SLOT_ROLLING, fields.rolling, nx, ny, slide.rolling);
            gpu.upload(slots.SLOT_VELOCITY_X, fields.speed, nx, ny, slide.speed);
            if (fields.mixture) gpu.upload(slots.SLOT_MIXTURE, fields.mixture, nx, ny, this.mixture());
            gpu.bind(slots.SLOT_RELIEF, null);
            gpu.bind(slots.SLOT_LAYERS, null);
            gpu.bind(slots.SLOT_UNDISTURBED, fields.firstDepth);
            gpu.into(this.surface, nx, ny);
            gpu.fill(this.programs.surface);
            gpu.bind(slots.SLOT_LAYERS, fields.layers);
            gpu.bind(slots.SLOT_UNDISTURBED, fields.firstDepthFiltered);
            this.tiles.findBlocks();
        }
        if (slide.extent && slide.extent !== this.sentExtent)
            gpu.upload(slots.SLOT_EXTENT, fields.extent, nx, ny, slide.extent.inside);
        this.sentExtent = slide.extent;
        if (overlay && overlay !== this.sentOverlay)
            gpu.upload(slots.SLOT_MEASURE, fields.measure, nx, ny, this.measure(overlay));
        this.sentOverlay = overlay;
    }

    // Made once there is any.
    earthTexture() {
        const {gl, gpu, slots, slide} = this, {nx, ny} = slide.info.grid;
        return this.fields.earth ??= gpu.texture(slots.SLOT_EARTH, gl.R16F, nx, ny, gl.LINEAR, slide.earth);
    }

    // Two bytes per vertex.
    mixture() {
        const {lowerDepth, lowerRolling} = this.slide, bytes = new Uint8Array(2 * lowerDepth.length);
        for (let i = 0; i < lowerDepth.length; ++i) {
            bytes[2 * i] = Math.round(255 * lowerDepth[i]);
            bytes[2 * i + 1] = Math.round(255 * lowerRolling[i]);
        }
        return bytes;
    }

    // A legend with values on both sides of 0 is drawn by the numbers of its stops, because overlay.glsl begins at 0.
    isTwoSided(overlay) {
        return overlay.stops[0][0] < 0;
    }

    // The stops, as frame.glsl has them.
    legend(overlay) {
        return overlay.stops.flatMap(([value, ...colour], i) => [...colour, this.isTwoSided(overlay) ? i + 1 : value]);
    }

    // The overlay's value times its weight, and the weight, of each vertex.
    measure(overlay) {
        const {slide} = this, visible = this.frame.floats('rolling')[3], stops = overlay.stops.map(stop => stop[0]);
        const twoSided = this.isTwoSided(overlay), thinnest = Math.min(...stops.map(Math.abs));
        const numbered = value => {
            const after = stops.findIndex(stop => stop >= value);
            if (after <= 0) return after < 0 ? stops.length : 1;
            return after + (value - stops[after - 1]) / (stops[after] - stops[after - 1]);
        };
        // Of a vertex: the value, and the depth that must be seen.
        const read = {
            s: i => [slide.speed[i], slide.rolling[i]], R: i => [slide.rolling[i], slide.rolling[i]],
            d: i => [slide.depth[i], Infinity], change: i => [slide.depth[i] - this.firstDepth[i], Infinity],
            peak_depth: i => [slide.peakDepth[i], slide.peakDepth[i]],
            peak_speed: i => [slide.peakSpeed[i], slide.peakDepth[i]],
        }[overlay.field];
        const measured = new Float32Array(2 * slide.depth.length);
        for (let i = 0; i < slide.depth.length; ++i) {
            if (this.site[i] === this.slots.SITE_DRAIN) continue;
            const [value, depth] = read(i);
            const weight = Math.min(0.5 * (twoSided ? Math.abs(value) / thinnest : depth / visible), 1);
            measured[2 * i] = weight * (twoSided ? numbered(value) : value);
            measured[2 * i + 1] = weight;
        }
        return measured;
    }

    drawDepth() {
        const {gl, gpu} = this;
        gpu.bind(this.slots.SLOT_RELIEF, this.fields.relief);
        this.into('scene');
        gl.depthFunc(gl.GEQUAL);
        gl.clearDepth(0.5);  // infinitely far away: window_depth.glsl
        gl.clear(gl.DEPTH_BUFFER_BIT);
        gl.colorMask(false, false, false, false);
        gpu.enabled([gl.DEPTH_TEST, gl.CULL_FACE], () => gpu.drawMesh(this.programs.depth, this.surfaceMesh));
        gl.colorMask(true, true, true, true);
        this.keepDepth();
    }

    // Copies the depth for shaders to read: they cannot read what is drawn into.
    keepDepth() {
        const {gl, gpu} = this, {width, height, frames, ground} = this.target;
        gpu.copy(frames.scene, frames.ground, width, height, gl.DEPTH_BUFFER_BIT);
        gpu.bind(this.slots.SLOT_SCENE_DEPTH, ground);
        this.into('scene');
    }

    drawDebris([, withSlides, withWalls]) {
        const {gl, gpu, slots, slide} = this, {debris} = this.programs, [albedo, relief] = this.target.skin;
        gpu.bind(slots.SLOT_SKIN_ALBEDO, null);
        gpu.bind(slots.SLOT_SKIN_RELIEF, null);
        gpu.bind(slots.SLOT_RELIEF, this.fields.filtered);
        this.into('skin');
        debris.use();
        gl.uniform1f(debris.at('seconds'), slide.tick * slide.info.tick_s);
        gpu.drawRectangles(debris, [...withSlides, ...withWalls]);
        gpu.bind(slots.SLOT_SKIN_ALBEDO, albedo);
        gpu.bind(slots.SLOT_SKIN_RELIEF, relief);
        this.into('scene');
    }

    // The same of a world that goes on, with the texture that the flow has carried, cut along its fronts.
    drawFlow() {
        const {gl, gpu, slots} = this, {vertices, indices, version} = this.slide.flow, [albedo, relief] = this.target.skin;
        if (this.sentFlow !== version) {
            this.sentFlow = version;
            this.flowMesh ??= gpu.growing([2, 4, 4, 4, 4, 2]);
            gpu.refill(this.flowMesh, vertices, indices);
        }
        gpu.bind(slots.SLOT_SKIN_ALBEDO, null);
        gpu.bind(slots.SLOT_SKIN_RELIEF, null);
        gpu.bind(slots.SLOT_RELIEF, this.fields.relief);
        this.into('flow');
        gl.clearColor(0, 0, 0, 0);
        gl.clear(gl.COLOR_BUFFER_BIT);
        gl.depthMask(false);
        gl.polygonOffset(...kFlowOffset);
        gpu.enabled([gl.DEPTH_TEST, gl.CULL_FACE, gl.POLYGON_OFFSET_FILL], () => gpu.drawMesh(this.programs.flow, this.flowMesh));
        gl.polygonOffset(0, 0);
        gl.depthMask(true);
        gpu.bind(slots.SLOT_SKIN_ALBEDO, albedo);
        gpu.bind(slots.SLOT_SKIN_RELIEF, relief);
        this.into('scene');
    }

    shadeTerrain(rectangles, overlay, cursor) {
        const {gl, gpu, slots, fields} = this;
        const shading = overlay ? this.shading('marks.glsl', 'overlay.glsl')
            : cursor || this.slide.extent ? this.shading('marks.glsl', 'overlay_none.glsl') : this.shading('marks_none.glsl');
        gpu.bind(slots.SLOT_RELIEF, fields.filtered);
        gpu.bind(slots.SLOT_EXTENT, fields.extent);  // which others use as well
        gpu.bind(slots.SLOT_LAND, fields.land);      // as this
        gl.depthMask(false);
        gl.depthFunc(gl.LESS);
        gpu.enabled([gl.DEPTH_TEST], () =>
            rectangles.forEach((corners, kind) => gpu.drawRectangles(shading[kind], corners)));
        gl.depthFunc(gl.GEQUAL);
        gl.depthMask(true);
        gpu.bind(slots.SLOT_RELIEF, fields.relief);
    }

    drawWalls() {
        const {gl, gpu} = this;
        gpu.enabled([gl.DEPTH_TEST, gl.CULL_FACE], () => gpu.drawMesh(this.programs.walls, this.wallMesh));
    }

    // The part of the target that a box may cover: left, bottom, right, top in samples; null if none. As
    // render/view/on_screen.cpp.
    onScreen({clip, near}, low, high) {
        const {width, height} = this.target, beyond = [0, 0, 0, 0];
        const left = [Infinity, Infinity], right = [-Infinity, -Infinity];  // and below, above
        let behind = 0;
        for (let corner = 0; corner < 8; ++corner) {
            const at = [0, 1, 2].map(k => corner >> k & 1 ? high[k] : low[k]);
            const [x, y, w] = projected(clip, at);
            beyond[0] += x < -w, beyond[1] += x > w, beyond[2] += y < -w, beyond[3] += y > w;
            if (w < near) {
                ++behind;
                continue;
            }
            [[x, width], [y, height]].forEach(([place, size], k) => {
                const sample = (0.5 + 0.5 * clamp(place / w, -2, 2)) * size;
                left[k] = Math.min(left[k], sample - 1);
                right[k] = Math.max(right[k], sample + 2);
            });
        }
        if (behind === 8 || beyond.includes(8)) return null;
        if (behind > 0) return [0, 0, width, height];
        const part = [...left.map(edge => Math.max(edge, 0)), Math.min(right[0], width), Math.min(right[1], height)];
        return part[0] < part[2] && part[1] < part[3] ? part : null;
    }

    // The sky is smooth, so that a sixteenth of its pixels are enough; sun, moon and stars are not.
    drawSky() {
        const {gl, gpu, slots, programs} = this, {width, height, frames, sky} = this.target;
        gpu.bind(slots.SLOT_SKY, null);
        gpu.into(frames.sky, Math.ceil(width / 4), Math.ceil(height / 4));
        gpu.fill(programs.sky);
        gpu.bind(slots.SLOT_SKY, sky);
        this.into('scene');
        gpu.enabled([gl.DEPTH_TEST], () => gpu.fill(programs.lights));
    }

    // Draws into the picture without its depth, which shaders read.
    beginAir() {
        this.into('air');
        this.gpu.bind(this.slots.SLOT_SCENE_DEPTH, this.target.depth);
    }

    // Maps light to what a screen shows, on the canvas. Chromium does not see what is blitted there.
    show() {
        const {gl, gpu, slots, programs, target: {width, height, isSmoothed, frames, colour, stepped, smooth}} = this;
        gpu.bind(slots.SLOT_COLOUR, colour);
        gpu.bind(slots.SLOT_PICTURE, null);
        gpu.into(isSmoothed ? frames.stepped : null, width, height);
        gpu.fill(programs.tone);
        if (!isSmoothed) return;
        gpu.copy(frames.stepped, frames.smooth, width, height, gl.COLOR_BUFFER_BIT);
        gpu.bind(slots.SLOT_PICTURE, stepped);
        this.smoothEdges();
        gpu.bind(slots.SLOT_PICTURE, smooth);
        gpu.into(null, width, height);
        gpu.fill(programs.copied);
    }

    // Edges are marked by depth, and only they are smoothed.
    smoothEdges() {
        const {gl, gpu, programs} = this;
        this.into('smooth');
        gl.clearDepth(1);
        gl.clear(gl.DEPTH_BUFFER_BIT);
        gpu.enabled([gl.DEPTH_TEST], () => {
            gl.depthFunc(gl.ALWAYS);
            gl.colorMask(false, false, false, false);
            gpu.fill(programs.edgeMarks);
            gl.colorMask(true, true, true, true);
            gl.depthFunc(gl.EQUAL);
            gpu.fill(programs.edges);
        });
    }

    // ---- for tests ----

    // The bytes of the last picture, from its lowest row on. A canvas that is read later is empty.
    pixels() {
        const {gl} = this, {width, height} = this.target, bytes = new Uint8Array(4 * width * height);
        gl.bindFramebuffer(gl.FRAMEBUFFER, null);
        gl.readPixels(0, 0, width, height, gl.RGBA, gl.UNSIGNED_BYTE, bytes);
        return {width, height, bytes};
    }

    // Mean ms of each pass and of all, over some pictures of what draw() takes.
    time(input, count) {
        this.passes = {};
        for (let i = 0; i < count; ++i) {
            this.sentTick = null;
            this.draw(input);
        }
        const times = Object.fromEntries(Object.entries(this.passes).map(([pass, ms]) => [pass, ms / count]));
        this.passes = null;
        return {...times, all: Object.values(times).reduce((a, b) => a + b, 0)};
    }
}
