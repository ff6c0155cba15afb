// Trees: which of the trees a camera sees, and how each is drawn, as render/woods/trees_in_view.cpp finds them.
const kHalfWidth = 0.19, kHalfWidths = {TREE_PINE: 0.8, TREE_BEECH: 0.26, TREE_BIRCH: 0.185, TREE_BUSH: 0.58};  // of a tree, of its height
const kWiderInStand = 0.2, kBushGone = 5, kBushWhole = 20;  // pixels of height: below the first no bush is drawn
const kWideOfHeight = 0.0145, kLeastWide = 5.5, kMostWide = 10.5;  // of the mean tree: of the frame's height, pixels
const kMeanWidth = 5, kMostTogether = 20;  // m; trees that one stands for
const kGroup = 8, kWidthOfGroup = 0.75, kTaller = 0.4;
const kLongestShadow = 36, kShadowPixels = 7;  // m; height below which a tree casts none
const kCrushed = 0.65, kLaid = 1.5;  // width of a lying tree, of a standing one's; rad
const kShallow = 0.15, kDeep = 0.6, kSlow = 1.5, kFast = 4.5;  // m and m/s: a flow bends a tree from the first on
const kLies = 0.5;  // of being laid down, from which it is drawn so
const kLean = 0.05, kMostLean = 0.22, kLeaning = 0.06;  // tangents of standing ones; share of those that lean most
const kOfForest = 2, kPlanted = 3;  // of trees.on: by the forest of the world; by a hand on this page
const kForestGone = 0, kForestLies = 2;  // as game/live/picture.h has it
const kTreeColumns = ['x', 'y', 'z', 'height', 'on', 'snow', 'lower', 'closed', 'group', 'kind', 'sun', 'falls', 'keeps'];
const kPlantedColumns = ['x', 'y', 'z', 'height', 'chance', 'snow', 'closed', 'kind', 'keeps', 'lies'];
const kTreeNumbers = 20;  // numbers of a drawn tree: struct Tree of tree.glsl
const kTreesInARow = 256;  // of their texture: tree_texture.glsl

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
        this.halfWidths = new Map(Object.entries(kHalfWidths).map(([kind, half]) => [constants[kind], half]));
        this.ground = new Ground(slide);
        this.begun = Object.fromEntries(kTreeColumns.map(name => [name, slide.array('trees.' + name) ?? new Float32Array(0)]));
        this.begun.chance = this.begun.x.map((_, i) => ownNumber(i));
        this.counts = [...(slide.array('trees.count') ?? [])];
        Object.assign(this, this.begun);
        this.findTiles(this.counts);
        this.first = this.drawn = new Float32Array(0);  // numbers as they stood, and as they are
        this.withShadow = 0;
    }

    // Adds those that people have planted to those of tick 0, tile by tile: numbers of each, as game/live/picture.h has them.
    plant({trees, counts}) {
        const width = kPlantedColumns.length, added = trees.length / width;
        const column = k => Float32Array.from({length: added}, (_, i) => trees[width * i + k]);
        const planted = Object.fromEntries(kPlantedColumns.map((name, k) => [name, column(k)]));
        const same = {group: 1, sun: 1, on: kPlanted};  // in all of them; the rest is 0
        for (const [name, begun] of Object.entries(this.begun)) {
            if (begun.length < this.begun.x.length) continue;  // the page has no such column
            this[name] = new Float32Array(begun.length + added).fill(same[name] ?? 0);
            this[name].set(begun);
            this[name].set(planted[name] ?? [], begun.length);
        }
        this.lying = planted.lies;
        this.findTiles([...this.counts, ...counts]);
    }

    // A tile's trees and the box around their feet and tops.
    findTiles(counts) {
        this.tiles = [];
        let first = 0;
        for (const count of counts) {
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

    // Finds the trees that a camera sees, as they stood at tick 0. `view`: of viewOf(); `box`: null where a box is not
    // seen.
    find(view, box) {
        this.standing = [];
        for (const {first, count} of this.tiles.filter(tile => box(tile.low, tile.high)))
            for (let k = 0; k < count; ++k) {
                // Of few trees of a tile not always one is left.
                const tree = this.seenTree(first + k, (k + this.chance[first]) / count, view);
                if (tree) this.standing.push(tree);
            }
        // What they hide is not shaded.
        this.standing.sort((a, b) => a.distance - b.distance || a.i - b.i);
        this.withShadow = this.standing.findLastIndex(tree => tree.shadow > 0) + 1;
        this.write();
    }

    // How a tree is drawn; null if it is not. `rank`: among those of its tile, 0 to 1.
    seenTree(i, rank, {eye, forward, right, up, pixel}) {
        const away = [this.x[i] - eye[0], this.y[i] - eye[1], this.z[i] - eye[2]];
        const distance = Math.max(Math.hypot(...away), 1), highRay = Math.hypot(...up), group = this.group[i];
        const wide = clamp(kWideOfHeight * 2 * highRay / pixel, kLeastWide, kMostWide);
        const isBush = this.kind[i] === this.constants.TREE_BUSH;
        const share = isBush ? smoothstep(kBushGone, kBushWhole, this.height[i] / (distance * pixel))
            : clamp(kMeanWidth * group / (distance * pixel) / wide, group / kMostTogether, 1);
        if (rank >= share) return null;
        // One that is left out shrinks first.
        const kept = (share < 1 ? Math.min((share - rank) / (0.15 * share), 1) : 1) * this.parted(i, eye, away);
        if (kept <= 0) return null;
        const deep = dot(away, forward), radius = kLongestShadow + this.height[i];
        const isBeside = (ray, half) =>
            Math.abs(dot(away, ray)) / half > deep * half + radius * Math.sqrt(1 + half * half);
        if (deep < -radius || isBeside(right, Math.hypot(...right)) || isBeside(up, highRay)) return null;

        // Near the eye it is one tree, even if it stands for more.
        const together = isBush ? 1 : Math.min(group / share, Math.max(wide * distance * pixel / kMeanWidth, 1));
        const isGroup = together > kGroup, tops = isGroup ? Math.round(together) : 1;
        const taller = Math.pow(Math.min(together, kGroup), kTaller), height = this.height[i] * kept * taller;
        const slim = this.halfWidths.get(this.kind[i]) ?? kHalfWidth;
        const broad = slim * this.height[i] * kept * together / taller * (1 + kWiderInStand * this.closed[i]);
        const half = Math.max(isGroup ? kWidthOfGroup * broad : broad, 0.6 * kept * distance * pixel);
        const pixels = height / (distance * pixel);
        const shadow = this.sun[i] * smoothstep(1, 2, pixels / (kShadowPixels * (isBush ? 4 : 1 + 3 * this.closed[i])));
        return {i, distance, height, half, tops, shadow};
    }

    // The wood parts before the eye, which would see nothing within a crown: a tree shrinks as the eye comes near.
    parted(i, eye, away) {
        const height = this.height[i];
        if (eye[2] > this.z[i] + 1.2 * height) return 1;
        return smoothstep(0.25 * height, 0.5 * height, Math.hypot(away[0], away[1]));
    }

    // Writes them as they stood at tick 0, and lists those on the grid, where a flow may come.
    write() {
        const rows = Math.ceil(this.standing.length / kTreesInARow), room = kTreeNumbers * kTreesInARow * rows;
        if (this.first.length < room) {
            this.first = new Float32Array(room);
            this.drawn = new Float32Array(room);
        }
        const {nx, dx} = this.slide.info.grid;
        this.onGrid = [];
        this.standing.forEach(({i, height, half, tops, shadow}, number) => {
            const at = kTreeNumbers * number, tip = shadow > 0 ? this.tipOfShadow(i) : [0, 0, 0];
            this.first.set([this.x[i], this.y[i], this.z[i], height, ...this.upright(i), this.chance[i],
                            this.sun[i], 0, this.lower[i] ?? 0, half, ...tip, shadow,
                            this.kind[i], tops, this.closed[i], this.keeps[i]], at);
            const vertex = Math.round(this.y[i] / dx) * nx + Math.round(this.x[i] / dx);
            if (this.on[i]) this.onGrid.push({i, at, vertex});
        });
    }

    // Puts them where they are at the shown moment: the snow around them has gone, or a flow has laid them down.
    // Returns the rows of the texture that they fill.
    settle() {
        const {depth, tick, info} = this.slide, frame = tick / info.every;
        this.drawn.set(this.first);
        for (const {i, at, vertex} of this.onGrid) {
            this.drawn[at + 2] -= Math.max(this.snow[i] - depth[vertex], 0);
            if (this.isGone(i, vertex)) this.drawn.fill(0, at, at + kTreeNumbers);
            else if (this.lies(i, vertex, frame)) this.lay(i, this.drawn.subarray(at, at + kTreeNumbers));
        }
        return Math.ceil(this.standing.length / kTreesInARow);
    }

    // Whether somebody has felled it.
    isGone(i, vertex) {
        return this.on[i] === kOfForest && this.slide.stands?.[vertex] === kForestGone;
    }

    // In a world that goes on by what the flow has done at its stem, as render/woods/trees_in_view.cpp finds it.
    lies(i, vertex, frame) {
        const {live, peakDepth, peakSpeed} = this.slide;
        if (!live) return this.falls[i] <= frame;
        if (this.on[i] === kPlanted) return this.lying[i - this.begun.x.length] === 1;
        if (this.on[i] === kOfForest) return this.slide.stands?.[vertex] === kForestLies;
        const strength = 0.7 + 0.6 * this.own(i, 19.1);
        return smoothstep(kShallow * strength, kDeep * strength, peakDepth[vertex]) *
            smoothstep(kSlow, kFast, peakSpeed[vertex]) >= kLies;
    }

    own(i, factor) {
        return fraction(this.chance[i] * factor);
    }

    // The way its stem points. Few trees are plumb.
    upright(i) {
        const most = Math.SQRT2 * (this.own(i, 83.3) < kLeaning ? kMostLean : kLean);
        const way = [most * (this.own(i, 23.9) - 0.5), most * (this.own(i, 61.7) - 0.5), 1], whole = Math.hypot(...way);
        return way.map(part => part / whole);
    }

    // Lays a tree into the deposit, with its top downhill.
    lay(i, tree) {
        const own = factor => this.own(i, factor), height = this.height[i];
        const [downX, downY] = this.downhill(i), aside = 1.1 * (own(37.3) - 0.5), whole = Math.sqrt(1 + aside * aside);
        const x = (downX - aside * downY) / whole, y = (downY + aside * downX) / whole;
        const radius = kCrushed * kHalfWidth * height, ground = (east, north) => this.ground.heightAt(east, north);
        // Some lie on the deposit, and some look out of it with one end.
        const rootZ = ground(tree[0], tree[1]) + radius * (0.5 - 1.2 * own(71.9));
        const topZ = ground(tree[0] + height * x, tree[1] + height * y) + radius * (0.9 - 1.5 * own(53.7));
        const flat = Math.hypot(height, topZ - rootZ), sine = Math.sin(kLaid), cosine = Math.cos(kLaid);
        const toTop = [height * x, height * y, topZ - rootZ];
        const axis = this.upright(i).map((part, k) => cosine * part + sine * toTop[k] / flat);
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
