// Powder: what is drawn of the puffs at a moment, as render/flow/powder_puffs.cpp finds it.
const kGrowth = 3.2, kFadeIn = 0.3;  // first radii that a puff gains over its life; s: sim/powder/cloud.cpp
const kThickness = 0.42;  // of an opaque puff, through its middle
const kScattered = 0.15;  // of the light, passed on from grain to grain
const kFaintest = 0.01;  // opacity from which on a puff is drawn
const kNearest = 4, kFar = 8;  // radii: nearer puffs are not drawn, from here on all of them is
const kHidden = 0.02, kSeen = 0.06;  // what nearer puffs leave to see of one, from which it is drawn, and drawn whole
const kCore = 0.65, kCoreShare = 0.6;  // part of the radius that hides, and of the opacity there
const kShadeSide = 64, kAcross = 64, kUp = 36;  // cells of a shade map, and of the veil
const kPuffNumbers = 12;  // numbers of a drawn puff: attributes of powder.vert

const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
const scaled = (a, by) => a.map(part => part * by);

// What a light coming from far away meets on its way: a map across its direction.
class ShadeMap {
    constructor() { this.cells = new Float32Array(2 * kShadeSide * kShadeSide); }

    // Sets each puff's light from `direction`, under the key `light`.
    cast(puffs, direction, light) {
        const aside = Math.abs(direction[2]) < 0.9 ? [0, 0, 1] : [1, 0, 0], a = cross(aside, direction);
        const across = scaled(a, 1 / Math.hypot(...a)), up = cross(direction, across);
        let left = Infinity, right = -Infinity, bottom = Infinity, top = -Infinity;
        for (const puff of puffs) {
            const x = dot(across, puff.at), y = dot(up, puff.at);
            left = Math.min(left, x - puff.radius), right = Math.max(right, x + puff.radius);
            bottom = Math.min(bottom, y - puff.radius), top = Math.max(top, y + puff.radius);
            puff.along = dot(direction, puff.at);
        }
        const side = Math.max(right - left, top - bottom);
        this.across = [...scaled(across, 1 / side), -left / side];
        this.up = [...scaled(up, 1 / side), -bottom / side];
        this.cells.fill(0);
        for (const puff of [...puffs].sort((p, q) => q.along - p.along || p.number - q.number)) {
            const [x, y] = [this.across, this.up].map(axis => kShadeSide * (dot(axis, puff.at) + axis[3]));
            puff[light] = kScattered + (1 - kScattered) * Math.exp(-this.thickness(x, y));
            this.add(x, y, puff.radius * kShadeSide / side, kThickness * puff.opacity, puff.along);
        }
    }

    thickness(x, y) {
        x = clamp(x - 0.5, 0, kShadeSide - 1.001), y = clamp(y - 0.5, 0, kShadeSide - 1.001);
        const i = Math.floor(x), j = Math.floor(y), at = 2 * (j * kShadeSide + i), c = this.cells;
        const above = at + 2 * kShadeSide;
        return lerp(lerp(c[at], c[at + 2], x - i), lerp(c[above], c[above + 2], x - i), y - j);
    }

    add(x, y, reach, thickness, along) {
        const wide = Math.max(reach, 1);
        thickness *= Math.min(reach * reach, 1);  // a puff smaller than a cell covers part of it
        const last = at => Math.min(Math.floor(at + wide), kShadeSide - 1), lastX = last(x), lastY = last(y);
        for (let j = Math.max(Math.floor(y - wide), 0); j <= lastY; ++j)
            for (let i = Math.max(Math.floor(x - wide), 0); i <= lastX; ++i) {
                const dx = (i + 0.5 - x) / wide, dy = (j + 0.5 - y) / wide;
                const more = thickness * Math.max(1 - dx * dx - dy * dy, 0);
                this.cells[2 * (j * kShadeSide + i)] += more;
                this.cells[2 * (j * kShadeSide + i) + 1] += more * along;
            }
    }
}

// What near puffs leave to see of those behind them: a map of the frame.
class VeilMap {
    constructor() { this.share = new Float32Array(kAcross * kUp); }

    // Calls `each(cell, x, y)` for the cells under an ellipse's box; x and y are in half axes from its middle.
    over(puff, size, each) {
        const cell = (at, cells) => Math.floor((0.5 + 0.5 * clamp(at, -1, 1)) * (cells - 0.001));
        const [x, y] = puff.middle, w = size * puff.half[0], h = size * puff.half[1];
        for (let j = cell(y - h, kUp); j <= cell(y + h, kUp); ++j)
            for (let i = cell(x - w, kAcross); i <= cell(x + w, kAcross); ++i)
                each(j * kAcross + i, ((i + 0.5) / kAcross * 2 - 1 - x) / w, ((j + 0.5) / kUp * 2 - 1 - y) / h);
    }

    seen(puff) {
        let most = 0;
        this.over(puff, 1, cell => most = Math.max(most, this.share[cell]));
        return most;
    }

    lay(puff) {
        this.over(puff, kCore, (cell, x, y) => {
            if (x * x + y * y < 1) this.share[cell] *= 1 - kCoreShare * puff.shown;
        });
    }
}

class PowderPuffs {
    constructor(slide, constants) {
        this.slide = slide;
        this.tickSeconds = slide.info.tick_s;
        this.shadowRadii = constants.POWDER_SHADOW;
        const get = name => slide.array('puffs.' + name);
        this.born = get('born'), this.life = get('life'), this.radius = get('radius');
        this.density = get('density'), this.lower = get('lower'), this.seed = get('seed');
        this.places = ['', '_half', '_end'].map(part => ['x', 'y', 'z'].map(axis => get(axis + part)));
        this.shade = new ShadeMap();
        this.skyShade = new ShadeMap();
        this.veil = new VeilMap();
        this.longest = this.life ? this.life.reduce((a, b) => Math.max(a, b), 0) : 0;
        this.drawn = new Float32Array(0);
        this.count = 0;
    }

    // The puffs in the air at a tick.
    at(tick) {
        if (this.slide.live) return this.ofWorld(this.slide.live.puffs);
        const puffs = [];
        if (!this.born) return puffs;
        let first = 0, end = this.born.length;  // they are sorted by birth
        for (const earliest = tick - this.longest / this.tickSeconds; first < end;) {
            const middle = (first + end) >> 1;
            if (this.born[middle] < earliest) first = middle + 1;
            else end = middle;
        }
        for (let i = first; i < this.born.length && this.born[i] <= tick; ++i) {
            const age = (tick - this.born[i]) * this.tickSeconds, a = age / this.life[i];
            if (a >= 1) continue;
            const radius = this.radius[i] * this.grown(a), opacity = this.density[i] * this.shown(age, a);
            // A parabola through its places at birth, in the middle and at the end of its life; the slide has the ways
            // from one to the next.
            const half = a * (3 - 2 * a), end = a * (2 * a - 1), [first, toHalf, toEnd] = this.places;
            const at = first.map((from, k) => from[i] + half * toHalf[k][i] + end * toEnd[k][i]);
            puffs.push({number: i, at, radius, opacity, age, a, lower: this.lower[i], turn: this.seed[i] / 256});
        }
        return puffs;
    }

    // Of a world that goes on, in the order of sim::powder::Puff.
    ofWorld(numbers) {
        const whole = new Uint32Array(numbers.buffer, numbers.byteOffset, numbers.length), puffs = [];
        for (let i = 0; i < numbers.length; i += kPuffNumbers) {
            const age = numbers[i + 7], a = age / numbers[i + 8];
            puffs.push({number: i, at: [...numbers.subarray(i, i + 3)], radius: numbers[i + 6] * this.grown(a),
                        opacity: numbers[i + 9] * this.shown(age, a), age, a, lower: numbers[i + 10],
                        turn: (whole[i + 11] & 255) / 256});
        }
        return puffs;
    }

    // By its age, s, and the share of its life: first radii, and the share of its density that is seen.
    grown(a) {
        return 1 + kGrowth * a * (2 - a);
    }
    shown(age, a) {
        return smoothstep(0, kFadeIn, age) * (1 - smoothstep(0, 0.8, a) * (0.75 + 0.25 * smoothstep(0.5, 1, a)));
    }

    // Finds those that are drawn, from far to near. `sun`: unit vector. Returns whether there are any.
    find(tick, view, sun) {
        const puffs = this.at(tick);
        this.count = 0;
        if (puffs.length === 0) return false;
        this.meanRadius = puffs.reduce((sum, puff) => sum + puff.radius, 0) / puffs.length;
        const inView = this.findInView(puffs, view, sun);
        if (inView.length === 0) return false;
        this.shade.cast(puffs, sun, 'fromSun');
        this.skyShade.cast(puffs, [0, 0, 1], 'fromSky');
        inView.sort((p, q) => q.distance - p.distance || p.number - q.number);
        this.hideBehindNearer(inView);
        this.write(inView.filter(puff => puff.shown > 0));
        this.box = this.box.map(edge => clamp(edge, -1, 1));
        return this.count > 0;
    }

    findInView(puffs, {eye, forward, right, up, clip}, sun) {
        const wide = Math.hypot(...right), high = Math.hypot(...up);
        this.box = [1, 1, -1, -1];  // left, bottom, right, top
        // Includes what a ball covers at a place. Returns its middle and half axes; null if that is beside the frame.
        const include = (at, radius, nearest) => {
            const [x, y, w] = projected(clip, at);
            if (w < nearest * radius) return null;
            const middle = [x / w, y / w], half = [radius / wide / w, radius / high / w];
            if ([0, 1].some(k => Math.abs(middle[k]) - half[k] > 1)) return null;
            for (const k of [0, 1]) {
                this.box[k] = Math.min(this.box[k], middle[k] - half[k]);
                this.box[2 + k] = Math.max(this.box[2 + k], middle[k] + half[k]);
            }
            return {middle, half};
        };
        this.mixed = false;
        return puffs.filter(puff => {
            if (puff.opacity < kFaintest) return false;
            // The shadow of a puff beside the frame may fall into it.
            for (let radii = 1; radii <= this.shadowRadii; ++radii) {
                const away = radii * Math.max(puff.radius, this.meanRadius);
                include(puff.at.map((part, k) => part - away * sun[k]), puff.radius, 1);
            }
            puff.distance = dot(puff.at.map((part, k) => part - eye[k]), forward);
            const parted = smoothstep(kNearest * puff.radius, kFar * puff.radius, puff.distance);
            puff.shown = puff.opacity * parted * parted - kFaintest;
            const place = puff.shown >= 0 && include(puff.at, puff.radius, kNearest);
            if (!place) return false;
            Object.assign(puff, place);
            this.mixed = this.mixed || puff.lower > 0;
            return true;
        });
    }

    // Most puffs of a thick cloud are behind others, and cost the most.
    hideBehindNearer(inView) {
        this.veil.share.fill(1);
        this.covered = 0;  // by all puffs in view, in areas of the frame
        for (let i = inView.length; i-- > 0;) {
            const puff = inView[i];
            puff.shown *= smoothstep(kHidden, kSeen, this.veil.seen(puff));
            if (puff.shown <= 0) continue;
            this.veil.lay(puff);
            this.covered += 0.785 * puff.half[0] * puff.half[1];
        }
    }

    write(puffs) {
        const room = kPuffNumbers * puffs.length;
        if (this.drawn.length < room) this.drawn = new Float32Array(2 * room);
        puffs.forEach(({at, radius, shown, fromSun, fromSky, turn, age, a, lower}, i) =>
            this.drawn.set([...at, radius, shown, fromSun, fromSky, turn, age, a, lower, 0], kPuffNumbers * i));
        this.count = puffs.length;
    }
}
