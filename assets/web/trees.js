// Trees: which of the trees a camera sees, and how each is drawn, as render/trees_in_view.cpp finds them.
const kHalfWidth = 0.19, kHalfWidthOfPine = 0.8, kWiderInStand = 0.2;  // of a tree, of its height
const kNearPixels = 100;  // height from which a tree has more than one triangle
const kWideOfHeight = 0.0145, kLeastWide = 5.5, kMostWide = 10.5;  // of the mean tree: of the frame's height, pixels
const kMeanWidth = 5, kMostTogether = 20;  // m; trees that one stands for
const kGroup = 5, kWidthOfGroup = 0.75, kTaller = 0.4;
const kLongestShadow = 36, kShadowPixels = 7;  // m; height below which a tree casts none
const kCrushed = 0.65, kLean = 1.5;  // width of a lying tree, of a standing one's; rad
const kTreeNumbers = 20;  // numbers of a drawn tree: struct Tree of tree.glsl

const fraction = x => x - Math.floor(x);

// 0 up to `from`, 1 from `to` on, smooth between.
function smoothstep(from, to, x) {
    const t = clamp((x - from) / (to - from), 0, 1);
    return t * t * (3 - 2 * t);
}

// A number of a tree's own, 0 to 1.
function ownNumber(i) {
    let h = Math.imul(i + 1, 0x9E3779B1);
    h = Math.imul(h ^ h >>> 15, 0x2C1B3C6D);
    h = Math.imul(h ^ h >>> 12, 0x297A2D39);
    return ((h ^ h >>> 15) >>> 8) / 16777216;
}

class TreesInView {
    // `sun`: unit vector to the light. `constants`: of slots.glsl.
    constructor(slide, sun, constants) {
        this.slide = slide;
        this.sunAt = sun;
        this.constants = constants;
        this.ground = new Ground(slide);
        const get = name => slide.array('trees.' + name);
        this.x = get('x'), this.y = get('y'), this.z = get('z');
        this.height = get('height'), this.on = get('on');
        this.snow = get('snow'), this.lower = get('lower'), this.closed = get('closed');
        this.group = get('group'), this.kind = get('kind'), this.sun = get('sun');
        this.falls = get('falls');
        this.findTiles(get('count'));
        this.chance = new Float32Array(this.x ? this.x.length : 0).map((_, i) => ownNumber(i));
        this.drawn = new Float32Array(0);
        this.numbers = [];
        this.near = this.far = this.withShadow = 0;
    }

    // A tile's trees and the box around their feet and tops.
    findTiles(counts) {
        this.tiles = [];
        let first = 0;
        for (const count of counts || []) {
            const low = [Infinity, Infinity, Infinity], high = [-Infinity, -Infinity, -Infinity];
            for (let i = first; i < first + count; ++i) {
                const foot = [this.x[i], this.y[i], this.z[i]];
                for (let k = 0; k < 3; ++k) {
                    low[k] = Math.min(low[k], foot[k] - kLongestShadow);
                    high[k] = Math.max(high[k], foot[k] + (k === 2 ? this.height[i] : 0) + kLongestShadow);
                }
            }
            if (count > 0) this.tiles.push({first, count, low, high});
            first += count;
        }
    }

    // Finds the trees that a camera sees, as they stood at tick 0. `view`: of viewOf(); `box`: null where a box is not seen.
    find(view, box) {
        const {eye, forward, right, up, pixel} = view;
        const long = v => Math.hypot(v[0], v[1], v[2]), wideRay = long(right), highRay = long(up);
        const wide = clamp(kWideOfHeight * 2 * highRay / pixel, kLeastWide, kMostWide);
        const lists = {near: [], branched: [], plain: [], without: []};
        const seen = this.tiles.filter(tile => box(tile.low, tile.high));
        const away = tile => Math.hypot(...[0, 1, 2].map(k => eye[k] - clamp(eye[k], tile.low[k], tile.high[k])));
        for (const tile of seen) tile.away = away(tile);
        seen.sort((a, b) => a.away - b.away || a.first - b.first);
        for (const {first, count} of seen) {
            const own = this.chance[first];
            for (let k = 0, i = first; k < count; ++k, ++i) {
                const dx = this.x[i] - eye[0], dy = this.y[i] - eye[1], dz = this.z[i] - eye[2];
                const distance = Math.max(Math.hypot(dx, dy, dz), 1), tall = this.height[i];
                // One that is left out shrinks first.
                const share = clamp(kMeanWidth * this.group[i] / (distance * pixel) / wide, this.group[i] / kMostTogether, 1);
                const rank = (k + own) / count;
                if (rank >= share) continue;
                const parted = eye[2] > this.z[i] + 1.2 * tall ? 1 : smoothstep(0.25 * tall, 0.5 * tall, Math.hypot(dx, dy));
                const kept = (share < 1 ? Math.min((share - rank) / (0.15 * share), 1) : 1) * parted;
                if (kept <= 0) continue;
                const deep = dx * forward[0] + dy * forward[1] + dz * forward[2], radius = kLongestShadow + tall;
                const outside = (ray, half) => Math.abs(dx * ray[0] + dy * ray[1] + dz * ray[2]) / half >
                        deep * half + radius * Math.sqrt(1 + half * half);
                if (deep < -radius || outside(right, wideRay) || outside(up, highRay)) continue;

                const together = this.group[i] / share, taller = Math.pow(Math.min(together, kGroup), kTaller);
                const height = tall * kept * taller, pixels = height / (distance * pixel), isGroup = together > kGroup;
                const broad = (this.kind[i] === this.constants.TREE_PINE ? kHalfWidthOfPine : kHalfWidth) * tall * kept * together /
                        taller * (1 + kWiderInStand * this.closed[i]);
                const half = Math.max(isGroup ? kWidthOfGroup * broad : broad, 0.6 * kept * distance * pixel);
                const tops = isGroup ? Math.round(together) : 1;
                const shadow = this.sun[i] * smoothstep(1, 2, pixels / (kShadowPixels * (1 + 3 * this.closed[i])));
                const tree = {i, distance, height, half, tops, shadow};
                const branches = isGroup ? 24 * half / tops / (distance * pixel) : pixels;
                const list = this.group[i] < 2 && pixels > kNearPixels * (0.85 + 0.3 * this.chance[i]) ? 'near'
                        : branches > this.constants.TREE_PLAIN_PIXELS ? 'branched' : shadow > 0 ? 'plain' : 'without';
                lists[list].push(tree);
            }
        }
        lists.near.sort((a, b) => a.distance - b.distance || a.i - b.i);
        this.standing = [...lists.near, ...lists.branched, ...lists.plain, ...lists.without];
        this.near = lists.near.length;
        this.far = lists.branched.length;
        this.withShadow = this.standing.length - lists.without.length;
        if (this.drawn.length < kTreeNumbers * this.standing.length) this.drawn = new Float32Array(2 * kTreeNumbers * this.standing.length);
    }

    // Puts them where they are at the shown moment: the snow around them has gone, or a flow has laid them down.
    settle() {
        const {nx, dx} = this.slide.info.grid, frame = this.slide.tick / this.slide.info.every;
        this.standing.forEach(({i, height, half, tops, shadow}, number) => {
            const tree = this.drawn.subarray(kTreeNumbers * number, kTreeNumbers * number + kTreeNumbers);
            const column = Math.round(this.x[i] / dx), row = Math.round(this.y[i] / dx);
            const sunk = this.on[i] ? Math.max(this.snow[i] - this.slide.depth[row * nx + column], 0) : 0;
            tree.set([this.x[i], this.y[i], this.z[i] - sunk, height, 0, 0, 1, this.chance[i], this.sun[i], this.snow[i], this.lower ? this.lower[i] : 0, half,
                                ...this.tipOfShadow(i), shadow, this.kind[i], tops, this.closed[i], 0]);
            if (this.on[i] && this.falls[i] <= frame) this.lay(i, tree);
        });
        return this.drawn;
    }

    // Lays a tree into the deposit, with its top downhill.
    lay(i, tree) {
        const own = factor => fraction(this.chance[i] * factor);
        const [downX, downY] = this.downhill(i), aside = 1.1 * (own(37.3) - 0.5), whole = Math.sqrt(1 + aside * aside);
        const along = [(downX - aside * downY) / whole, (downY + aside * downX) / whole], height = this.height[i];
        const radius = kCrushed * kHalfWidth * height;
        // Some lie on the deposit, and some look out of it with one end.
        const rootZ = this.ground.heightAt(tree[0], tree[1]) + radius * (0.5 - 1.2 * own(71.9));
        const topZ = this.ground.heightAt(tree[0] + height * along[0], tree[1] + height * along[1]) + radius * (0.9 - 1.5 * own(53.7));
        const flat = Math.hypot(height, topZ - rootZ), sine = Math.sin(kLean);
        const axis = [sine * along[0] * height / flat, sine * along[1] * height / flat, Math.cos(kLean) + sine * (topZ - rootZ) / flat];
        const size = Math.hypot(...axis);
        tree[2] = rootZ;
        tree.set(axis.map(part => part / size), 4);
        tree[11] *= kCrushed;
        tree[15] = 0;
    }

    // Unit vector in plan.
    downhill(i) {
        const {dx} = this.slide.info.grid, at = (x, y) => this.ground.heightAt(this.x[i] + x, this.y[i] + y);
        const down = [at(-dx, 0) - at(dx, 0), at(0, -dx) - at(0, dx)], steep = Math.hypot(...down);
        return steep > 0 ? down.map(part => part / steep) : [1, 0];
    }

    // Where the shadow of its top meets the ground.
    tipOfShadow(i) {
        const [x, y, z] = this.sunAt, flat = Math.max(Math.hypot(x, y), 1e-3);
        const length = Math.min(this.height[i] * flat / Math.max(z, 0.01), kLongestShadow);
        const tip = [this.x[i] - x * length / flat, this.y[i] - y * length / flat];
        return [...tip, this.ground.heightAt(...tip)];
    }
}
