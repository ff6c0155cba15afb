#pragma once

#include <glm/vec2.hpp>

#include "sim/world/state.h"

namespace game {

// A place between four vertices of a grid: the lower left one and the fraction across, each 0 to 1.
struct Square {
    int x = 0, y = 0;
    glm::dvec2 across{0};
};

// Outside the grid: the nearest place on its border.
Square square_under(const sim::Grid& grid, glm::dvec2 at);

// Bilinear interpolation between the corners.
double between(const Square& square, const sim::Field<float>& field);

// Height of the surface above the terrain's zero, bilinear, m; outside the grid that of the nearest border.
double surface_height(const sim::View& world, glm::dvec2 at);

}  // namespace game
