// The world that a page plays, in a thread of its own, so that the page never stalls: the module of game/live, asked one
// question at a time. Joined to no other file of the page.
'use strict';

let module = null;   // the exported functions
let memory = null;
let over = false;    // its last words were said: of an instance that has thrown only what remains is read
let proving = false;  // the recording is replayed while nobody asks for anything else
const kProofTicks = 30;     // between two looks at what is asked
const kTold = 100;          // ms between two words about the proof
const kPlantedNumbers = 10;  // of a tree: LivePicture::Planted
const kPuffNumbers = 12;    // of a puff: sim::powder::Puff
const kFieldNames = ['bed', 'depth', 'rolling', 'velocity_x', 'velocity_y', 'earth'];

// What the module asks of its surroundings: a clock, and who reads its last words. It opens no file.
function surroundings() {
    const words = (at, size) => new TextDecoder().decode(new Uint8Array(memory.buffer, at, size));
    const no = () => 8;  // WASI's "bad file descriptor"
    let lastWords = '';
    return {
        page: {ended(at, size) {
            over = true;
            throw new Error(words(at, size));
        }},
        wasi_snapshot_preview1: {
            clock_time_get(clock, precision, at) {
                new DataView(memory.buffer).setBigUint64(at, BigInt(Math.round(performance.now() * 1e6)), true);
                return 0;
            },
            fd_write(file, pieces, count, written) {
                const view = new DataView(memory.buffer);
                let size = 0;
                for (let i = 0; i < count; ++i) {
                    const length = view.getUint32(pieces + 8 * i + 4, true);
                    lastWords += words(view.getUint32(pieces + 8 * i, true), length);
                    size += length;
                }
                view.setUint32(written, size, true);
                return 0;
            },
            proc_exit(status) {
                over = true;
                throw new Error(lastWords.trim() || `ended with status ${status}`);
            },
            fd_close: no, fd_seek: no, fd_fdstat_get: no, fd_read: no, fd_prestat_get: no, fd_prestat_dir_name: no,
            environ_get: () => 0,
            environ_sizes_get(count, size) {
                const view = new DataView(memory.buffer);
                view.setUint32(count, 0, true), view.setUint32(size, 0, true);
                return 0;
            },
        },
    };
}

async function load(bytes) {
    const refused = what => ({message}) => {
        throw new Error(`This slide can be watched only: the browser refuses ${what} (${message})`);
    };
    const compiled = await WebAssembly.compile(bytes).catch(refused('the world in this page'));
    const has = surroundings();
    const imports = {};
    for (const {module: from, name} of WebAssembly.Module.imports(compiled)) {
        const known = has[from]?.[name];
        (imports[from] ??= {})[name] = known ?? (() => { throw new Error(`${name} is not there`); });
    }
    const instance = await WebAssembly.instantiate(compiled, imports).catch(refused('memory for the world in this page'));
    module = instance.exports;
    memory = module.memory;
    module._initialize();
}

const told = () => new TextDecoder().decode(new Uint8Array(memory.buffer, module.out_at(), module.out_size()));
function give(text) {
    const bytes = new TextEncoder().encode(text), at = module.in_buffer(bytes.length);
    new Uint8Array(memory.buffer, at, bytes.length).set(bytes);
}
function must(result) {
    if (result < 0) throw new Error(told());
    return result;
}

// ---- what the page shows ----

let lastBed = null;
let sun = [0, 0, 1];  // unit vector to the light

// A field as it is now: one value per vertex, row by row from the south-west. `into`: an array to fill again, or none.
function field(which, into) {
    const columns = module.columns(), rows = module.rows(), stride = module.stride();
    const from = new Float32Array(memory.buffer, module.field(kFieldNames.indexOf(which)), rows * stride);
    const out = into ?? new Float32Array(columns * rows);
    for (let y = 0; y < rows; ++y) out.set(from.subarray(y * stride, y * stride + columns), y * columns);
    return out;
}

function same(a, b) {
    if (!a || a.length !== b.length) return false;
    for (let i = 0; i < a.length; ++i) if (a[i] !== b[i]) return false;
    return true;
}

// All that the page draws of this moment, in arrays of its own. `spare`: arrays of an earlier answer, to be filled again.
function picture(spare = {}) {
    const depth = field('depth', spare.depth), rolling = field('rolling', spare.rolling);
    const speed = field('velocity_x', spare.speed), along_y = field('velocity_y', spare.along_y);
    for (let i = 0; i < speed.length; ++i)
        speed[i] = rolling[i] >= 0.01 ? Math.sqrt(speed[i] * speed[i] + along_y[i] * along_y[i]) : 0;
    const peak = which => new Float32Array(memory.buffer, module.peak(which), depth.length).slice();
    const puffs = new Float32Array(memory.buffer, module.puffs_at(), kPuffNumbers * module.puffs()).slice();
    const shown = {depth, rolling, speed, along_y, puffs, peakDepth: peak(0), peakSpeed: peak(1)};
    const bytes = (at, count) => at === 0 ? null : new Uint8Array(memory.buffer, at, count).slice();
    const mixture = bytes(module.mixture(), 2 * depth.length);
    if (mixture) shown.mixture = mixture;
    const floats = module.flow();
    if (floats >= 0) {
        shown.flowVertices = new Float32Array(memory.buffer, module.flow_vertices(), floats).slice();
        shown.flowIndices = new Uint32Array(memory.buffer, module.flow_indices(), module.flow_count()).slice();
    }
    if (module.plant()) {
        shown.planted = new Float32Array(memory.buffer, module.planted_at(), kPlantedNumbers * module.planted()).slice();
        shown.plantedCounts = new Uint32Array(memory.buffer, module.planted_counts(), module.planted_tiles()).slice();
        const stands = bytes(module.stands(), depth.length);
        if (stands) shown.stands = stands;
    }
    if (module.build(...sun)) shown.built = [0, 1, 2].map(which =>  // faces, ropes, shadows
        new Float32Array(memory.buffer, module.built_at(which), module.built(which)).slice());
    const bed = field('bed');
    if (!same(lastBed, bed)) {
        lastBed = bed;
        shown.bed = bed.slice();
        if (module.field(kFieldNames.indexOf('earth')) !== 0) shown.earth = field('earth');
    }
    return shown;
}

function now() {
    must(module.status());
    return JSON.parse(told());
}

// ---- what the page asks ----

// Lets questions in. By a message of its own: a timer would wait for 4 ms.
const channel = new MessageChannel(), resting = [];
channel.port1.onmessage = () => resting.shift()();
const rest = () => new Promise(resolve => {
    resting.push(resolve);
    channel.port2.postMessage(0);
});

// Replays what is watched, while nothing else is asked.
async function prove() {
    let last = 0;
    while (proving) {
        const done = module.advance(kProofTicks);
        if (done < kProofTicks) proving = false;
        const time = performance.now();
        if (time - last > kTold || !proving) {
            last = time;
            postMessage({proof: {exact: module.verdict() === 1, until: module.proven_until(), whole: !proving}});
        }
        await rest();
    }
}

async function goTo(tick) {
    while (must(module.seek(tick, kProofTicks)) === 0) await rest();
}

const questions = {
    // `light`: unit vector; `cover`: as LivePicture::cover() has it, or null.
    async open({bytes, name, recording, light, cover}) {
        await load(bytes);
        give(`${name}\n${recording}`);
        must(module.open());
        const facts = JSON.parse(told());
        if (light) sun = light;
        if (cover) {
            const at = module.cover(cover.length / 2);
            new Float32Array(memory.buffer, at, cover.length).set(cover);
        }
        proving = true;
        prove();
        return {facts};
    },
    async takeOver({tick}) {
        // What has been replayed in order is proven.
        while (proving && module.verdict() >= 0 && module.proven_until() < tick) await rest();
        proving = false;
        await goTo(tick);
        must(module.take_over());
        return {};
    },
    // From the beginning once more, with nothing done.
    async again() {
        await goTo(0);
        must(module.take_over());
        return {};
    },
    step({ticks, hand}) {
        let said = '';
        for (const [deed, ...where] of hand) {
            if (deed === 'brush') {
                give(JSON.stringify(where[0]));
                must(module.brush());
            } else {
                module[deed](...where);
            }
        }
        if (ticks > 0) {
            module.advance(ticks);
            said = told();
        }
        return {said};
    },
    wouldAct: () => ({acts: module.would_act() === 1}),
    async seek({tick}) {
        await goTo(tick);
        return {};
    },
    undo: () => {
        must(module.undo());
        return {name: told()};
    },
    async redo() {
        must(module.redo());
        const name = told();
        await goTo(now().known);
        return {name};
    },
    recorded: () => {
        must(module.recorded());
        return {text: told(), silent: true};
    },
};

// The recording of a world that has ended, up to its last whole line; nothing if nobody took it over.
function remains() {
    try {
        return new TextDecoder().decode(new Uint8Array(memory.buffer, module.remains_at(), module.remains_size()));
    } catch {  // it ended before it began
        return '';
    }
}

let turn = Promise.resolve();
onmessage = ({data}) => {
    turn = turn.then(() => answer(data));
};

async function answer({id, kind, spare, ...question}) {
    try {
        if (over) throw new Error('it has ended before');
        const answered = await questions[kind](question);
        if (answered.silent || kind === 'open' || kind === 'wouldAct') return postMessage({id, ...answered});
        const shown = picture(spare);
        postMessage({id, ...answered, status: now(), shown}, Object.values(shown).flat().map(array => array.buffer));
    } catch (error) {
        proving = false;
        over ||= error instanceof WebAssembly.RuntimeError;
        postMessage({id, failed: error.message, over, remains: over ? remains() : ''});
    }
}
