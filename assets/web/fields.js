// The slide that this page carries: numbers as JSON in #slide, fields as base64 of a gzip stream in #fields.
// The format is in docs/web.md.

const kTile = 8;                // vertices along the edge of a tile of the moving fields
const kPiece = 1 << 20;         // letters of base64 that are decoded at a time; a multiple of four
const kWorkBetweenCopies = 4e6; // vertices to change, so that a jump in time takes a few hundredths of a second
const kMostCopies = 24;

// Reads the page's own data. Throws an error whose message is a sentence for the viewer.
async function unpackSlide() {
    try {
        const info = JSON.parse(document.getElementById('slide').textContent);
        const packed = document.getElementById('fields');
        const parts = await unzip(packed.textContent.trim(), info.parts);
        packed.remove();  // frees the text
        return new Slide(info, parts);
    } catch (cause) {
        throw new Error('The data of this page is damaged. Copy or download the file again.', {cause});
    }
}

// Decodes and unzips a text into its parts, by name. `pieces`: names and sizes in the order of the stream. Pieces of one
// name continue each other.
async function unzip(text, pieces) {
    const parts = new Map();
    for (const [name, size] of pieces) parts.set(name, (parts.get(name) ?? 0) + size);
    for (const [name, size] of parts) parts.set(name, {bytes: new Uint8Array(size), filled: 0});

    const reader = decoded(text).stream().pipeThrough(new DecompressionStream('gzip')).getReader();
    let chunk = new Uint8Array(), at = 0;
    const next = async () => {
        const {done, value} = await reader.read();
        chunk = value;
        at = 0;
        return !done;
    };
    for (const [name, size] of pieces) {
        const part = parts.get(name);
        for (const end = part.filled + size; part.filled < end;) {
            if (at === chunk.length && !await next()) throw new Error(`the stream ends in part ${name}`);
            const some = chunk.subarray(at, at + end - part.filled);
            part.bytes.set(some, part.filled);
            part.filled += some.length;
            at += some.length;
        }
    }
    if (at !== chunk.length || await next()) throw new Error('the stream is longer than its parts');
    return new Map([...parts].map(([name, {bytes}]) => [name, bytes]));
}

// The bytes of a base64 text, in pieces, so that there is no second copy of all of it.
function decoded(text) {
    const pieces = [];
    for (let at = 0; at < text.length; at += kPiece) {
        const letters = atob(text.slice(at, at + kPiece));
        const piece = new Uint8Array(letters.length);
        for (let i = 0; i < letters.length; ++i) piece[i] = letters.charCodeAt(i);
        pieces.push(piece);
    }
    return new Blob(pieces);
}

// The whole number that a zigzag code stands for: 0, −1, 1, −2, 2, …
function unzigzag(code) {
    return (code >>> 1) ^ -(code & 1);
}

// The moving fields of one stored frame, as whole numbers. Changes between frames are sums of whole numbers, so
// that a cursor goes both ways and comes back to the same bits.
class FieldCursor {
    // `fields`: as Slide keeps them. `copies`: frames to start from, shared between cursors.
    constructor(fields, nx, ny, copies) {
        this.fields = fields;
        this.nx = nx;
        this.ny = ny;
        this.tilesAcross = Math.ceil(nx / kTile);
        this.copies = copies;
        this.frame = copies[0].frame;
        this.values = copies[0].values.map(values => values.slice());
    }

    copy() {
        return {frame: this.frame, values: this.values.map(values => values.slice())};
    }

    // Goes to a frame from the nearest copy, or from where it is.
    go(frame, work) {
        const away = from => Math.abs(work[frame + 1] - work[from + 1]);
        let start = this;
        for (const copy of this.copies)
            if (away(copy.frame) < away(start.frame)) start = copy;
        if (start !== this) {
            this.frame = start.frame;
            this.values.forEach((values, i) => values.set(start.values[i]));
        }
        while (this.frame < frame) this.change(++this.frame, 1);
        while (this.frame > frame) this.change(this.frame--, -1);
    }

    change(frame, sign) {
        this.fields.forEach((field, i) => this.changeField(field, this.values[i], frame, sign));
    }

    changeField({map, mapBytes, low, high, start}, values, frame, sign) {
        let at = start[frame] * kTile * kTile;
        for (let byte = 0; byte < mapBytes; ++byte) {
            let bits = map[frame * mapBytes + byte];
            for (let tile = 8 * byte; bits !== 0; bits >>= 1, ++tile) {
                if ((bits & 1) === 0) continue;
                const x = tile % this.tilesAcross * kTile, y = Math.floor(tile / this.tilesAcross) * kTile;
                const columns = Math.min(kTile, this.nx - x), rows = Math.min(kTile, this.ny - y);
                for (let row = 0; row < rows; ++row) {
                    const from = at + row * kTile, to = (y + row) * this.nx + x;
                    for (let column = 0; column < columns; ++column) {
                        const code = low[from + column] | high[from + column] << 8;
                        if (code !== 0) values[to + column] += sign * unzigzag(code);
                    }
                }
                at += kTile * kTile;
            }
        }
    }
}

// A slide at one time. Fields have one value per vertex, row by row from the south-west.
class Slide {
    // `parts`: bytes by name.
    constructor(info, parts) {
        this.info = info;
        this.parts = parts;
        this.files = JSON.parse(new TextDecoder().decode(this.part('files')));

        const {nx, ny} = info.grid;
        this.bed = this.array('bed');             // m above the datum
        this.earth = this.array('earth');         // m that it was raised by, or null
        this.firstDepth = this.array('d0');       // m
        this.site = this.array('site');           // 1: no ground
        this.peakDepth = this.array('peak_depth');  // m
        this.peakSpeed = this.array('peak_speed');  // m/s
        this.depth = new Float32Array(nx * ny);     // m, of the standing layer
        this.rolling = new Float32Array(nx * ny);   // m, depth of the rolling layer
        this.speed = new Float32Array(nx * ny);     // m/s in plan, of the rolling layer
        this.surface = new Float32Array(nx * ny);   // m above the datum: ground and both layers
        this.lowerDepth = info.two ? new Float32Array(nx * ny) : null;    // share of the lower material, 0 to 1, at
        this.lowerRolling = info.two ? new Float32Array(nx * ny) : null;  // the standing surface; in the rolling layer
        this.shown = {d: this.depth, R: this.rolling, s: this.speed, lower_d: this.lowerDepth,
                      lower_R: this.lowerRolling};

        this.fields = Object.keys(info.moving).map(name => this.movingField(name));
        this.findWork();
        const first = {d: this.quanta('d0'), lower_d: this.quanta('lower0')};
        const copies = [{frame: -1, values: this.fields.map(({name}) =>
            first[name] ? Uint16Array.from(first[name]) : new Uint16Array(nx * ny))}];
        this.makeCopies(copies);
        this.before = new FieldCursor(this.fields, nx, ny, copies);
        this.after = new FieldCursor(this.fields, nx, ny, copies);
        this.tick = -1;
        this.version = 0;      // one more whenever something that is shown changes
        this.live = null;      // what a world that goes on has shown last, if one does
        this.seek(0);
    }

    part(name, size) {
        const part = this.parts.get(name);
        if (!part || (size !== undefined && part.length !== size)) throw new Error(`part ${name} is not as it should be`);
        return part;
    }

    // The text of a shader file of the program, without its folder.
    file(name) {
        if (!(name in this.files)) throw new Error(`the page has no file ${name}`);
        return this.files[name];
    }

    // An array as whole numbers; null if the slide has none of that name.
    quanta(name) {
        const format = this.info.arrays[name];
        if (!format) return null;
        const [width, height = 1] = format.size;
        const planes = Array.from({length: format.planes}, (_, i) => this.part(`${name}.${i}`, width * height));
        const mask = -1 >>> (32 - 8 * format.planes);
        const out = new Uint32Array(width * height);
        for (let y = 0, i = 0; y < height; ++y)
            for (let x = 0; x < width; ++x, ++i) {
                let code = 0, expected = 0;
                for (let plane = format.planes - 1; plane >= 0; --plane) code = code << 8 | planes[plane][i];
                if (format.predict === 'last' && i > 0) expected = out[i - 1];
                if (format.predict === 'plane') {
                    if (x > 0) expected += out[i - 1];
                    if (y > 0) expected += out[i - width];
                    if (x > 0 && y > 0) expected -= out[i - width - 1];
                }
                out[i] = (unzigzag(code) + expected) & mask;
            }
        return out;
    }

    // The values of an array; null if the slide has none of that name.
    array(name) {
        const format = this.info.arrays[name];
        return format ? Float32Array.from(this.quanta(name), q => format.zero + format.step * q) : null;
    }

    movingField(name) {
        const {zero, step} = this.info.moving[name], {frames, grid} = this.info;
        const tiles = Math.ceil(grid.nx / kTile) * Math.ceil(grid.ny / kTile), mapBytes = Math.ceil(tiles / 8);
        const map = this.part(`${name}.map`, frames * mapBytes);
        const start = new Uint32Array(frames + 1);  // changed tiles before each frame
        for (let frame = 0, i = 0; frame < frames; ++frame) {
            let count = start[frame];
            for (const end = i + mapBytes; i < end; ++i)
                for (let bits = map[i]; bits !== 0; bits &= bits - 1) ++count;
            start[frame + 1] = count;
        }
        const bytes = start[frames] * kTile * kTile;
        return {name, zero, step, map, mapBytes, start, low: this.part(`${name}.0`, bytes),
                high: this.part(`${name}.1`, bytes)};
    }

    // Finds the vertices to change until after frame k, as work[k + 1].
    findWork() {
        this.work = new Float64Array(this.info.frames + 1);
        for (const {start, mapBytes} of this.fields)
            for (let frame = 0; frame <= this.info.frames; ++frame)
                this.work[frame] += start[frame] * kTile * kTile + frame * mapBytes;
    }

    // Adds copies of frames in the middle of a long slide.
    makeCopies(copies) {
        const {frames, grid: {nx, ny}} = this.info, total = this.work[frames];
        const between = Math.max(kWorkBetweenCopies, total / kMostCopies);
        if (total < between) return;
        const cursor = new FieldCursor(this.fields, nx, ny, copies.slice());
        for (let frame = 0, next = between; frame < frames; ++frame) {
            cursor.change(++cursor.frame, 1);
            if (this.work[frame + 1] < next) continue;
            copies.push(cursor.copy());
            next = this.work[frame + 1] + between;
        }
    }

    tickOf(frame) {
        return Math.min(frame * this.info.every, this.info.last);
    }

    // The stored frame nearest to a tick.
    frameNear(tick) {
        const frame = Math.min(Math.floor(tick / this.info.every), this.info.frames - 1);
        const next = Math.min(frame + 1, this.info.frames - 1);
        return this.tickOf(next) - tick < tick - this.tickOf(frame) ? next : frame;
    }

    // Sets the fields to a tick; between two stored frames they are blended.
    seek(asked) {
        const tick = Math.max(0, Math.min(this.info.last, asked));
        if (tick === this.tick || this.live) return;
        this.tick = tick;
        ++this.version;
        const frame = Math.min(Math.floor(tick / this.info.every), this.info.frames - 1);
        const next = Math.min(frame + 1, this.info.frames - 1);
        this.before.go(frame, this.work);
        this.after.go(next, this.work);
        const span = this.tickOf(next) - this.tickOf(frame);
        this.share = span > 0 ? (tick - this.tickOf(frame)) / span : 0;  // of the later frame
        this.fields.forEach(({name, zero, step}, i) => {
            const out = this.shown[name], from = this.before.values[i], to = this.after.values[i], share = this.share;
            if (!out) return;
            if (share === 0)
                for (let k = 0; k < out.length; ++k) out[k] = zero + step * from[k];
            else
                for (let k = 0; k < out.length; ++k) out[k] = zero + step * (from[k] + (to[k] - from[k]) * share);
        });
        this.findSurface();
    }

    findSurface() {
        const {bed, depth, rolling, surface} = this;
        for (let k = 0; k < surface.length; ++k) surface[k] = bed[k] + depth[k] + rolling[k];
    }

    // Shows a state of a world that goes on, exact, instead of a stored one. `shown`: as live_worker.js has it.
    become(tick, shown) {
        this.tick = tick;
        this.live = shown;
        ++this.version;
        this.depth.set(shown.depth);
        this.rolling.set(shown.rolling);
        this.speed.set(shown.speed);
        this.peakDepth.set(shown.peakDepth);
        this.peakSpeed.set(shown.peakSpeed);
        if (shown.mixture)
            for (let i = 0; i < this.depth.length; ++i) {
                this.lowerDepth[i] = shown.mixture[2 * i] / 255;
                this.lowerRolling[i] = shown.mixture[2 * i + 1] / 255;
            }
        this.flow = shown.flowVertices && {vertices: shown.flowVertices, indices: shown.flowIndices, version: this.version};
        if (shown.built) this.built = shown.built, this.builtVersion = this.version;
        if (shown.bed) this.bed.set(shown.bed), this.bedVersion = this.version;
        if (shown.earth) this.earth = shown.earth;
        if (shown.planted) {
            this.planted = {trees: shown.planted, counts: shown.plantedCounts};
            this.stands = shown.stands;
        }
        this.findSurface();
    }

    // The values at the vertex and in the stored frame nearest to a point and to the time of the picture; null
    // where there is no ground.
    read(x, y) {
        const {grid: {nx, ny, dx, datum}} = this.info;
        const column = Math.round(x / dx), row = Math.round(y / dx), i = row * nx + column;
        if (!(column >= 0 && row >= 0 && column < nx && row < ny) || (this.site && this.site[i] > 0)) return null;
        const cursor = this.share > 0.5 ? this.after : this.before;
        const now = {};
        this.fields.forEach(({name, zero, step}, f) =>
            now[name] = this.live ? this.shown[name]?.[i] : zero + step * cursor.values[f][i]);
        return {
            column, row, x: column * dx, y: row * dx, tick: this.live ? this.tick : this.tickOf(cursor.frame),
            height: datum + this.bed[i] + now.d + now.R,
            standing: now.d, rolling: now.R, speed: now.s, change: now.d - this.firstDepth[i],
            peakDepth: this.peakDepth[i], peakSpeed: this.peakSpeed[i],
            lowerStanding: now.lower_d, lowerRolling: now.lower_R,
        };
    }
}
