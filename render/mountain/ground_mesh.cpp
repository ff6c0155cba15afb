#include "render/mountain/ground_mesh.h"

#include <algorithm>

#include <glm/common.hpp>

#include "assets/shaders/slots.glsl"
#include "sim/core/check.h"

namespace render {
namespace {

//   d ─── c     upper triangle a c d
//   │   ╱ │
//   │ ╱   │
//   a ─── b     lower triangle a b c
struct Squares {
    const sim::Grid& grid;
    const sim::Field<sim::Site>& site;

    bool ground(int x, int y) const { return site(x, y) != sim::Site::kDrain; }
    bool inside(int x, int y) const { return x >= 0 && y >= 0 && x + 1 < grid.nx && y + 1 < grid.ny; }
    bool lower(int x, int y) const {
        return inside(x, y) && ground(x, y) && ground(x + 1, y) && ground(x + 1, y + 1);
    }
    bool upper(int x, int y) const {
        return inside(x, y) && ground(x, y) && ground(x + 1, y + 1) && ground(x, y + 1);
    }
};

void add_wall(std::vector<std::uint32_t>& walls, std::uint32_t from, std::uint32_t to) {
    walls.insert(walls.end(), {from | INDEX_BASE, to | INDEX_BASE, to, from | INDEX_BASE, to, from});
}

void add_square(GroundMesh& mesh, const Squares& squares, int x, int y) {
    const std::uint32_t a = surface_index(x, y), b = surface_index(x + 1, y);
    const std::uint32_t c = surface_index(x + 1, y + 1), d = surface_index(x, y + 1);
    const bool lower = squares.lower(x, y), upper = squares.upper(x, y);
    if (lower) mesh.surface.insert(mesh.surface.end(), {a, b, c});
    if (upper) mesh.surface.insert(mesh.surface.end(), {a, c, d});
    if (lower && !squares.upper(x, y - 1)) add_wall(mesh.walls, a, b);
    if (lower && !squares.upper(x + 1, y)) add_wall(mesh.walls, b, c);
    if (lower && !upper) add_wall(mesh.walls, c, a);
    if (upper && !lower) add_wall(mesh.walls, a, c);
    if (upper && !squares.lower(x, y + 1)) add_wall(mesh.walls, c, d);
    if (upper && !squares.lower(x - 1, y)) add_wall(mesh.walls, d, a);
}

}  // namespace

double block_depth(const sim::Grid& grid) {
    constexpr double kShare = 0.06;  // of the longer side: visibly a block, but thin beside a mountain
    return kShare * grid.dx * (std::max(grid.nx, grid.ny) - 1);
}

std::uint32_t surface_index(int x, int y) {
    return static_cast<std::uint32_t>(y) << INDEX_Y_SHIFT | static_cast<std::uint32_t>(x);
}
std::uint32_t base_index(int x, int y) {
    return surface_index(x, y) | INDEX_BASE;
}

GroundMesh ground_mesh(const sim::Grid& grid, const sim::Field<sim::Site>& site) {
    CHECK(grid.nx <= INDEX_X_MASK + 1 && grid.ny <= INDEX_X_MASK + 1);
    const Squares squares{grid, site};
    GroundMesh mesh;
    mesh.surface.reserve(6 * grid.size());
    const glm::ivec2 last(grid.nx - 1, grid.ny - 1);
    for (int bottom = 0; bottom < last.y; bottom += GroundMesh::kBlock)
        for (int left = 0; left < last.x; left += GroundMesh::kBlock) {
            const glm::ivec2 lowest(left, bottom), highest = glm::min(lowest + GroundMesh::kBlock, last);
            const auto first = static_cast<std::uint32_t>(mesh.surface.size());
            for (int y = lowest.y; y < highest.y; ++y)
                for (int x = lowest.x; x < highest.x; ++x) add_square(mesh, squares, x, y);
            const auto count = static_cast<std::uint32_t>(mesh.surface.size()) - first;
            if (count > 0) mesh.blocks.push_back({first, count, lowest, highest});
        }
    return mesh;
}

}  // namespace render
