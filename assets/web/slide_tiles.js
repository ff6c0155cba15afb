// Which parts of the picture show what slides did: render/frame/slide_tiles.cpp. Elsewhere ground costs half as much.
const kScreenTile = 32;                               // samples along an edge
const kSlideBlock = 4, kSlideReach = 3, kWallReach = 2;  // vertices

class SlideTiles {
    constructor(slide, firstDepth) {
        this.slide = slide;
        this.firstDepth = firstDepth;
        const {nx, ny} = slide.info.grid;
        this.across = Math.ceil(nx / kSlideBlock);
        this.blocks = new Uint8Array(this.across * Math.ceil(ny / kSlideBlock));
    }

    // Finds the blocks of vertices near slides (1), and of those near walls where a slab broke off and near earth (2).
    findBlocks() {
        const {nx, ny} = this.slide.info.grid, {depth, rolling, earth} = this.slide;
        this.blocks.fill(0);
        for (let y = 0, i = 0; y < ny; ++y)
            for (let x = 0; x < nx; ++x, ++i) {
                if (earth && earth[i] !== 0) this.mark(x, y, kSlideReach, 2);
                if (rolling[i] === 0 && depth[i] === this.firstDepth[i]) continue;
                this.mark(x, y, kSlideReach, 1);
                if (this.isUnderWall(x, y)) this.mark(x, y, kWallReach, 2);
            }
    }

    mark(x, y, reach, kind) {
        const {nx, ny} = this.slide.info.grid, block = (at, count) => Math.floor(clamp(at, 0, count - 1) / kSlideBlock);
        for (let j = block(y - reach, ny); j <= block(y + reach, ny); ++j)
            for (let i = block(x - reach, nx), at = j * this.across + i; i <= block(x + reach, nx); ++i, ++at)
                this.blocks[at] = Math.max(this.blocks[at], kind);
    }

    // Whether the standing layer is gone here and still stands beside it. What rolls hides a wall.
    isUnderWall(x, y) {
        const {nx, ny} = this.slide.info.grid, {depth, rolling} = this.slide;
        const change = (i, j) => depth[j * nx + i] - this.firstDepth[j * nx + i], here = change(x, y);
        if (here > -0.09 || rolling[y * nx + x] > 0.3) return false;
        for (let j = Math.max(y - 1, 0); j <= Math.min(y + 1, ny - 1); ++j)
            for (let i = Math.max(x - 1, 0); i <= Math.min(x + 1, nx - 1); ++i)
                if (change(i, j) > Math.max(here + 0.09, -0.28)) return true;
        return false;
    }

    // Rectangles of a picture that show no slide, slides, and walls: corners from −1 to 1, four numbers each.
    // `onScreen`: where a box is seen, samples; null: nowhere.
    rectangles(width, height, onScreen) {
        const columns = Math.ceil(width / kScreenTile), rows = Math.ceil(height / kScreenTile);
        const tiles = new Uint8Array(columns * rows), kinds = [[], [], []];
        this.blocks.forEach((kind, number) => {
            const seen = kind > 0 && onScreen(...this.boxOf(number));
            if (!seen) return;
            const [left, bottom, right, top] = seen.map(edge => Math.floor(edge / kScreenTile));
            for (let row = bottom; row <= Math.min(top, rows - 1); ++row)
                for (let at = row * columns + left; at <= row * columns + Math.min(right, columns - 1); ++at)
                    tiles[at] = Math.max(tiles[at], kind);
        });
        // Tiles of one kind along each row are joined.
        for (let row = 0; row < rows; ++row)
            for (let column = 0, end; column < columns; column = end) {
                const kind = tiles[row * columns + column];
                for (end = column + 1; end < columns && tiles[row * columns + end] === kind;) ++end;
                const edge = (tile, size) => 2 * Math.min(tile * kScreenTile, size) / size - 1;
                kinds[kind].push(edge(column, width), edge(row, height), edge(end, width), edge(row + 1, height));
            }
        return kinds;
    }

    // Around a block and its neighbours' nearest vertices: lowest and highest corner.
    boxOf(number) {
        const {surface, info: {grid: {nx, ny, dx}}} = this.slide;
        const x = number % this.across * kSlideBlock, y = Math.floor(number / this.across) * kSlideBlock;
        const x0 = Math.max(x - 1, 0), x1 = Math.min(x + kSlideBlock, nx - 1);
        const y0 = Math.max(y - 1, 0), y1 = Math.min(y + kSlideBlock, ny - 1);
        let lowest = Infinity, highest = -Infinity;
        for (let j = y0; j <= y1; ++j)
            for (let i = x0; i <= x1; ++i) {
                lowest = Math.min(lowest, surface[j * nx + i]);
                highest = Math.max(highest, surface[j * nx + i]);
            }
        return [[x0 * dx, y0 * dx, lowest], [x1 * dx, y1 * dx, highest]];
    }
}
