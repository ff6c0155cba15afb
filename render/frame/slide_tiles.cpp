#include "render/frame/slide_tiles.h"

#include <algorithm>
#include <limits>

namespace render {
namespace {

constexpr int kTile = 32;  // samples along an edge
constexpr int kBlock = 4;  // vertices
constexpr int kReach =
    3;  // vertices from one that moved to the last place where it shows: splines, ragged edges

constexpr int kReachOfWall = 2;  // vertices from one under a wall

// Blocks that hold vertices from `first` to `last`, which may lie outside the grid.
int block_from(int first) {
    return std::max(first, 0) / kBlock;
}
int block_to(int last, int vertices) {
    return std::min(last, vertices - 1) / kBlock;
}

void keep_greater(std::uint8_t& kind, std::uint8_t other) {
    kind = std::max(kind, other);
}

std::size_t index(int column, int row, int columns) {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns) +
           static_cast<std::size_t>(column);
}

// Whether the standing layer is gone here and still stands beside it, as crown.glsl asks, with some room. What
// rolls hides a wall, if it rolls above it too. `first`: the row of its first depth, in rows of world.grid.nx values.
bool is_under_wall(const sim::View& world, const float* first, int x, int y) {
    constexpr float kGone = -0.09f, kStep = 0.09f, kStands = -0.28f, kHides = 0.3f;  // m
    const auto change = [&](int i, int j) {
        return world.depth(i, j) - first[static_cast<std::ptrdiff_t>(j - y) * world.grid.nx + i];
    };
    const float here = change(x, y);
    if (here > kGone) return false;
    const bool fills = world.rolling(x, y) > kHides;
    for (int j = std::max(y - 1, 0); j <= std::min(y + 1, world.grid.ny - 1); ++j)
        for (int i = std::max(x - 1, 0); i <= std::min(x + 1, world.grid.nx - 1); ++i)
            if (change(i, j) > std::max(here + kStep, kStands) && !(fills && world.rolling(i, j) > kHides))
                return true;
    return false;
}

}  // namespace

void SlideTiles::find(const FrameInput& input, const OnScreen& screen, bool by_kind) {
    resize(input.world.grid, screen.all().right, screen.all().top);
    before_.swap(tiles_);
    // A texture may lie wherever it moved before; without the first depth nobody knows where.
    const bool everywhere =
        input.look.flow && input.flow && (input.look.flow->everywhere || input.untouched().empty());
    std::fill(tiles_.begin(), tiles_.end(), static_cast<std::uint8_t>(by_kind ? everywhere : 2));
    std::fill(blocks_.begin(), blocks_.end(), std::uint8_t{0});
    const bool slides = !everywhere && find_blocks(input);
    const bool earth = input.world.things && find_earth(input);
    if (slides || earth) {
        for (int y = 0; y < blocks_along_y_; ++y)
            for (int x = 0; x < blocks_along_x_; ++x)
                if (blocks_[index(x, y, blocks_along_x_)] != 0) project(input.world, x, y, screen);
    }
    collect();
}

// Returns whether there is any slide.
bool SlideTiles::find_blocks(const FrameInput& input) {
    const sim::View& world = input.world;
    const std::span<const float> untouched = input.untouched();
    const bool is_known = !untouched.empty();
    bool any = false;
    for (int y = 0; y < grid_.ny; ++y) {
        const float *rolling = world.rolling.row(y), *depth = world.depth.row(y);
        const float* first =
            is_known ? &untouched[static_cast<std::size_t>(y) * static_cast<std::size_t>(grid_.nx)] : depth;
        for (int x = 0; x < grid_.nx; ++x) {
            if (rolling[x] == 0 && depth[x] == first[x]) continue;
            any = true;
            mark(x, y, kReach, 1);
            if (is_known && is_under_wall(world, first, x, y)) mark(x, y, kReachOfWall, 2);
        }
    }
    return any;
}

// Returns whether there is any earth or wet soil that is seen.
bool SlideTiles::find_earth(const FrameInput& input) {
    const sim::View& world = input.world;
    const bool with_water = input.shows_wet_soil();
    bool any = false;
    for (int y = 0; y < grid_.ny; ++y) {
        const float *earth = world.things->earth.row(y), *water = world.things->water.row(y);
        for (int x = 0; x < grid_.nx; ++x)
            if (earth[x] != 0 || (with_water && water[x] != 0)) mark(x, y, kReach, 3), any = true;
    }
    return any;
}

void SlideTiles::mark(int x, int y, int reach, std::uint8_t kind) {
    for (int j = block_from(y - reach); j <= block_to(y + reach, grid_.ny); ++j)
        for (int i = block_from(x - reach); i <= block_to(x + reach, grid_.nx); ++i)
            keep_greater(blocks_[index(i, j, blocks_along_x_)], kind);
}

// Marks the tiles in which a block may be seen.
void SlideTiles::project(const sim::View& world, int x, int y, const OnScreen& screen) {
    const int x0 = std::max(x * kBlock - 1, 0), x1 = std::min((x + 1) * kBlock, grid_.nx - 1);
    const int y0 = std::max(y * kBlock - 1, 0), y1 = std::min((y + 1) * kBlock, grid_.ny - 1);
    float lowest = std::numeric_limits<float>::max(), highest = std::numeric_limits<float>::lowest();
    for (int j = y0; j <= y1; ++j)
        for (int i = x0; i <= x1; ++i) {
            const float z = world.bedrock(i, j) + world.depth(i, j) + world.rolling(i, j);
            lowest = std::min(lowest, z);
            highest = std::max(highest, z);
        }
    const Rectangle seen =
        screen.box({grid_.dx * glm::vec2(x0, y0), lowest}, {grid_.dx * glm::vec2(x1, y1), highest});
    if (seen.empty()) return;
    for (int row = seen.bottom / kTile; row <= (seen.top - 1) / kTile; ++row)
        for (int column = seen.left / kTile; column <= (seen.right - 1) / kTile; ++column)
            keep_greater(tiles_[index(column, row, columns_)], blocks_[index(x, y, blocks_along_x_)]);
}

void SlideTiles::resize(const sim::Grid& grid, int width, int height) {
    if (grid == grid_ && width == width_ && height == height_) return;
    grid_ = grid;
    width_ = width;
    height_ = height;
    columns_ = (width + kTile - 1) / kTile;
    rows_ = (height + kTile - 1) / kTile;
    blocks_along_x_ = (grid.nx + kBlock - 1) / kBlock;
    blocks_along_y_ = (grid.ny + kBlock - 1) / kBlock;
    tiles_.resize(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_));
    before_.resize(tiles_.size());
    blocks_.resize(static_cast<std::size_t>(blocks_along_x_) * static_cast<std::size_t>(blocks_along_y_));
    with_earth_.reserve(tiles_.size());
    with_walls_.reserve(tiles_.size());
    with_slides_.reserve(tiles_.size());
    without_.reserve(tiles_.size());
}

void SlideTiles::mark_changes(ScreenTiles& tiles) const {
    for (int row = 0; row < rows_; ++row)
        for (int column = 0; column < columns_; ++column)
            if (const auto i = index(column, row, columns_); tiles_[i] != before_[i])
                tiles.mark({column * kTile, row * kTile, (column + 1) * kTile, (row + 1) * kTile});
}

// Joins tiles of one kind along each row.
void SlideTiles::collect() {
    with_earth_.clear();
    with_walls_.clear();
    with_slides_.clear();
    without_.clear();
    for (int row = 0; row < rows_; ++row)
        for (int column = 0; column < columns_;) {
            const auto kind = [&](int i) { return tiles_[index(i, row, columns_)]; };
            int end = column + 1;
            while (end < columns_ && kind(end) == kind(column)) ++end;
            (kind(column) == 3   ? with_earth_
             : kind(column) == 2 ? with_walls_
             : kind(column) == 1 ? with_slides_
                                 : without_)
                .push_back({column * kTile, row * kTile, std::min(end * kTile, width_),
                            std::min((row + 1) * kTile, height_)});
            column = end;
        }
}

}  // namespace render
