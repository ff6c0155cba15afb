// The texture of debris: blocks of snow or clods of soil, as render/textures/debris.cpp and lumps.cpp make them; these
// say what the numbers mean. Heights and lengths are in edges of the tile, those of a lump in its radii.
const kDebrisSize = 512;  // texels along an edge
const kLumpSides = 7, kWidestLump = 1.3, kOverhang = 3, kSeedsPerScale = 30;
const kDebrisOf = {
    snow: {
        height: 0.6, wall: 2.3, tilt: 0.4, rounding: 0.25, buried: 0.35, seed: 630,
        rough: [0.006, 30, 590], flat: 72, relief: 0.055,
        scales: [[86, 0.80, 0.30, 0.60], [54, 0.80, 0.30, 0.60], [34, 0.75, 0.30, 0.60], [22, 0.80, 0.35, 0.62],
                 [14, 0.80, 0.35, 0.60], [9, 0.90, 0.28, 0.55], [60, 0.12, 0.20, 0.50]],
        colours: [[0.06, 0.600, 0.672, 0.780], [0.20, 0.795, 0.842, 0.905], [0.34, 0.895, 0.922, 0.953],
                  [0.55, 0.953, 0.964, 0.977], [0.90, 0.990, 0.990, 0.987]],
    },
    soil: {
        height: 0.6, wall: 1.7, tilt: 0.5, rounding: 0.32, buried: 0.4, seed: 1230,
        rough: [0.022, 22, 880], flat: 64, relief: 0.045,
        scales: [[100, 0.80, 0.30, 0.60], [66, 0.80, 0.30, 0.60], [42, 0.75, 0.30, 0.60], [27, 0.75, 0.35, 0.60],
                 [17, 0.75, 0.35, 0.60], [10, 0.90, 0.28, 0.56], [80, 0.20, 0.20, 0.60]],
        colours: [[0.08, 0.195, 0.132, 0.085], [0.24, 0.390, 0.281, 0.188], [0.40, 0.545, 0.412, 0.290],
                  [0.60, 0.640, 0.503, 0.365], [0.90, 0.695, 0.577, 0.445]],
    },
};

// Hashes a cell of a lattice that repeats after `period` cells to 0 … 1: render/base/noise.h.
function latticeHash(x, y, period, seed) {
    const wrap = at => (at % period + period) % period;
    let h = Math.imul(wrap(x), 0x9E3779B1) ^ Math.imul(wrap(y), 0x85EBCA77) ^ Math.imul(seed, 0xC2B2AE3D);
    h = Math.imul(h ^ h >>> 15, 0x2C1B3C6D);
    h = Math.imul(h ^ h >>> 12, 0x297A2D39);
    return ((h ^ h >>> 15) >>> 8) / 16777216;
}

const lerp = (a, b, share) => a + (b - a) * share;
const ease = t => t * t * t * (t * (6 * t - 15) + 10);

class Debris {
    // `recipe`: of kDebrisOf.
    constructor(recipe) {
        this.recipe = recipe;
        this.heights = new Float32Array(kDebrisSize * kDebrisSize);
        recipe.scales.forEach((scale, i) => this.strew(scale, recipe.seed + i * kSeedsPerScale));
        this.roughen(...recipe.rough);
        this.flatten();
        this.stretch();
        this.gaussianise();
    }

    // Adds lumps of one size, at most one to each cell. Each stands on the height under its middle before the call.
    strew([period, share, smallest, largest], seed) {
        const before = this.heights.slice(), size = kDebrisSize;
        for (let y = 0; y < period; ++y)
            for (let x = 0; x < period; ++x) {
                if (latticeHash(x, y, period, seed) >= share) continue;
                const random = (which, low, high) => lerp(low, high, latticeHash(x, y, period, seed + which));
                const middle = [(x + random(1, 0.1, 0.9)) / period, (y + random(2, 0.1, 0.9)) / period];
                const radius = random(3, smallest, largest) / period;
                const foot = before[Math.floor(middle[1] * size) % size * size + Math.floor(middle[0] * size) % size];
                this.lay(middle, radius, this.planes(random), foot);
            }
    }

    // The planes that bound a lump: slope downhill along x and y, and height over its middle; one after the other.
    planes(random) {
        const {height, wall, tilt} = this.recipe;
        const turned = share => [Math.cos(2 * Math.PI * share), Math.sin(2 * Math.PI * share)];
        const steep = random(4, 0, tilt), [x, y] = turned(random(5, 0, 1)), planes = [steep * x, steep * y, height];
        for (let side = 1; side <= kLumpSides; ++side) {
            const own = wall * random(12 + side, 0.6, 1.4), away = random(19 + side, 0.6, 1);
            const [sideX, sideY] = turned((side - 1 + random(5 + side, 0, 0.9)) / kLumpSides);
            planes.push(own * sideX, own * sideY, own * away);
        }
        return planes;
    }

    lay([middleX, middleY], radius, planes, foot) {
        const {height, wall, rounding, buried} = this.recipe, size = kDebrisSize, reach = (kWidestLump + 0.1) * radius;
        const lastX = Math.ceil((middleX + reach) * size), lastY = Math.ceil((middleY + reach) * size);
        for (let y = Math.floor((middleY - reach) * size); y <= lastY; ++y)
            for (let x = Math.floor((middleX - reach) * size); x <= lastX; ++x) {
                const u = (x / size - middleX) / radius, v = (y / size - middleY) / radius;
                let h = wall * (kWidestLump - Math.sqrt(u * u + v * v));
                for (let k = 0; k < planes.length; k += 3) {
                    const plane = planes[k + 2] - planes[k] * u - planes[k + 1] * v, apart = Math.abs(h - plane);
                    h = Math.min(h, plane);
                    if (apart < rounding) h -= 0.25 * (rounding - apart) * (rounding - apart) / rounding;
                }
                h -= buried * height;
                const at = (y & size - 1) * size + (x & size - 1);
                this.heights[at] = Math.max(this.heights[at], foot + radius * (h < 0 ? kOverhang * h : h));
            }
    }

    // Adds noise.
    roughen(height, first, seed) {
        const {heights} = this, size = kDebrisSize;
        for (let octave = 0, period = first, weight = 0.5 * height; octave < 4; ++octave, period *= 2, weight *= 0.5) {
            const lattice = Float32Array.from({length: period * period},
                (_, i) => latticeHash(i % period, Math.floor(i / period), period, seed + octave));
            for (let y = 0, i = 0; y < size; ++y) {
                const v = y * period / size, row = Math.floor(v), up = ease(v - row);
                const south = row * period, north = (row + 1) % period * period;
                for (let x = 0; x < size; ++x, ++i) {
                    const u = x * period / size, west = Math.floor(u), along = ease(u - west);
                    const east = (west + 1) % period;
                    heights[i] += weight * lerp(lerp(lattice[south + west], lattice[south + east], along),
                                                lerp(lattice[north + west], lattice[north + east], along), up);
                }
            }
        }
    }

    // Takes away what is broader than lumps.
    flatten() {
        let broad = this.heights;
        for (let pass = 0; pass < 2; ++pass) broad = this.blurred(this.blurred(broad, 1, kDebrisSize), kDebrisSize, 1);
        this.heights.forEach((height, i) => this.heights[i] = height - broad[i]);
    }

    // Moving average along lines whose texels are `step` apart; lines are `next` apart.
    blurred(heights, step, next) {
        const size = kDebrisSize, reach = this.recipe.flat / 2, out = new Float32Array(heights.length);
        for (let line = 0; line < size; ++line) {
            const at = i => line * next + (i & size - 1) * step;
            let sum = 0;
            for (let i = -reach; i <= reach; ++i) sum += heights[at(i)];
            for (let i = 0; i < size; ++i) {
                out[at(i)] = sum / (2 * reach + 1);
                sum += heights[at(i + reach + 1)] - heights[at(i - reach)];
            }
        }
        return out;
    }

    stretch() {
        const lowest = this.heights.reduce((a, b) => Math.min(a, b));
        const highest = this.heights.reduce((a, b) => Math.max(a, b));
        this.heights.forEach((height, i) => this.heights[i] = (height - lowest) / (highest - lowest));
    }

    // Finds heights that have a Gaussian's shares, so that sheets can be blended, and the height that each stood for.
    gaussianise() {
        const sorted = this.heights.slice().sort(), count = sorted.length;
        const heightOf = byte =>
            sorted[Math.min(Math.floor(normalShareBelow(6 * (byte / 255 - 0.5)) * count), count - 1)];
        this.raw = new Float32Array(256);
        const limits = new Float32Array(256);  // raw heights, up to which a byte stands for them
        for (let byte = 0; byte < 256; ++byte) {
            this.raw[byte] = heightOf(byte);
            limits[byte] = heightOf(byte + 0.5);
        }
        this.bytes = Uint8Array.from(this.heights, height => {
            let low = 0, high = 255;
            while (low < high) {
                const middle = (low + high) >> 1;
                if (limits[middle] < height) low = middle + 1;
                else high = middle;
            }
            return low;
        });
    }

    // Texels for SLOT_GRAIN: slopes, height. `steepest`: slope of the largest byte.
    grain(steepest) {
        const size = kDebrisSize, {heights, bytes} = this, texels = new Uint8Array(4 * size * size);
        const perStep = 0.5 * this.recipe.relief * size * 127 / steepest;
        for (let i = 0; i < heights.length; ++i) {
            const x = i % size, row = i - x, at = place => heights[place & heights.length - 1];
            const alongX = at(row + (x + 1 & size - 1)) - at(row + (x - 1 & size - 1));
            const alongY = at(i + size) - at(i - size);
            texels[4 * i] = clamp(Math.round(128 + perStep * alongX), 0, 255);
            texels[4 * i + 1] = clamp(Math.round(128 + perStep * alongY), 0, 255);
            texels[4 * i + 2] = bytes[i];
            texels[4 * i + 3] = 255;
        }
        return texels;
    }

    // Colours of the 256 heights in sRGB, three bytes each and one that is not used.
    colours() {
        const stops = this.recipe.colours;
        return Uint8Array.from([...this.raw].flatMap(height => {
            const found = stops.findIndex(stop => stop[0] > height);
            const k = found < 0 ? stops.length - 1 : Math.max(found, 1);
            const [low, ...from] = stops[k - 1], [high, ...to] = stops[k];
            const share = clamp((height - low) / (high - low), 0, 1);
            return [...from.map((part, i) => Math.round(255 * lerp(part, to[i], share))), 255];
        }));
    }

    // Of the whole tile, in linear light.
    meanColour() {
        const colours = this.colours(), sums = [0, 0, 0], linear = byte => Math.pow(byte / 255, 2.2);
        for (const byte of this.bytes) for (let k = 0; k < 3; ++k) sums[k] += linear(colours[4 * byte + k]);
        return sums.map(sum => sum / this.bytes.length);
    }
}

function normalShareBelow(x) {
    let term = x, sum = x;
    for (let n = 1; n < 80; ++n) {
        term *= -x * x / (2 * n);
        sum += term / (2 * n + 1);
    }
    return 0.5 + sum / 2.5066282746310002;
}
