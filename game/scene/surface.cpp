#include "game/scene/surface.h"

#include <algorithm>

#include <glm/common.hpp>

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

}  // namespace game
