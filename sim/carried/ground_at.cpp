#include "sim/carried/ground_at.h"

#include <algorithm>
#include <cstddef>

#include <glm/common.hpp>

namespace sim::carried {

GroundAt ground_at(const View& world, std::span<const float> first_depth, glm::vec2 at) {
    const Grid& grid = world.grid;
    const glm::vec2 cell = at / grid.dx, last(grid.nx - 1, grid.ny - 1),
                    inside = glm::clamp(cell, glm::vec2(0), last);
    const int x = std::min(static_cast<int>(inside.x), grid.nx - 2),
              y = std::min(static_cast<int>(inside.y), grid.ny - 2);
    const float u = inside.x - static_cast<float>(x), v = inside.y - static_cast<float>(y);
    const auto between = [&](const auto& of) {
        const float south = of(x, y) + u * (of(x + 1, y) - of(x, y));
        const float north = of(x, y + 1) + u * (of(x + 1, y + 1) - of(x, y + 1));
        return south + v * (north - south);
    };
    const auto height = [&](int i, int j) {
        return world.bedrock(i, j) + world.depth(i, j) + world.rolling(i, j);
    };
    const float west = height(x, y), east = height(x + 1, y), north_west = height(x, y + 1),
                north_east = height(x + 1, y + 1);
    const float along_south = east - west, along_north = north_east - north_west;
    const float south = west + u * along_south, north = north_west + u * along_north;
    GroundAt here;
    here.surface = south + v * (north - south);
    here.flow = between(world.rolling);
    here.loose = between([&](int i, int j) {
        const std::size_t vertex =
            static_cast<std::size_t>(j) * static_cast<std::size_t>(grid.nx) + static_cast<std::size_t>(i);
        return world.depth(i, j) - (first_depth.empty() ? 0 : first_depth[vertex]);
    });
    here.velocity = {between(world.velocity_x), between(world.velocity_y)};
    here.slope = glm::vec2(along_south + v * (along_north - along_south), north - south) / grid.dx;
    here.outside = inside != cell;
    return here;
}

}  // namespace sim::carried
