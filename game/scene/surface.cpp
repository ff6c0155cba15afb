#include "game/scene/surface.h"

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace game {

Square square_under(const sim::Grid& grid, glm::dvec2 at) {
    const glm::dvec2 p =
        glm::clamp(at / static_cast<double>(grid.dx), glm::dvec2(0), glm::dvec2(grid.nx - 1, grid.ny - 1));
    const int x = std::min(static_cast<int>(p.x), grid.nx - 2),
              y = std::min(static_cast<int>(p.y), grid.ny - 2);
    return {x, y, p - glm::dvec2(x, y)};
}

double between(const Square& square, const sim::Field<float>& field) {
    const auto [x, y, across] = square;
    const double south = glm::mix<double>(field(x, y), field(x + 1, y), across.x),
                 north = glm::mix<double>(field(x, y + 1), field(x + 1, y + 1), across.x);
    return glm::mix(south, north, across.y);
}

double surface_height(const sim::View& world, glm::dvec2 at) {
    const Square square = square_under(world.grid, at);
    return between(square, world.bedrock) + between(square, world.depth) + between(square, world.rolling) +
           world.datum;
}

glm::vec2 ground_slope(const sim::View& world, int x, int y) {
    const sim::Field<float>& depth = world.smooth_depth ? *world.smooth_depth : world.depth;
    const auto along = [&](int dx, int dy) {
        const bool ahead = world.site(x + dx, y + dy) == sim::Site::kGround,
                   behind = world.site(x - dx, y - dy) == sim::Site::kGround;
        if (!ahead && !behind) return 0.f;
        const int x1 = ahead ? x + dx : x, y1 = ahead ? y + dy : y;
        const int x0 = behind ? x - dx : x, y0 = behind ? y - dy : y;
        // Separate differences keep the last digits of the layer.
        const float rise = (world.bedrock(x1, y1) - world.bedrock(x0, y0)) + (depth(x1, y1) - depth(x0, y0));
        return rise / (world.grid.dx * (ahead && behind ? 2.f : 1.f));
    };
    return {along(1, 0), along(0, 1)};
}

double speed_along_slope(glm::dvec2 velocity, glm::dvec2 slope) {
    const double rise = glm::dot(slope, velocity);
    return std::sqrt(glm::dot(velocity, velocity) + rise * rise);
}

}  // namespace game
