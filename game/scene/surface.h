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

// Tangents of the ground along which the rolling layer moves, toward east and north at a vertex: of bedrock and
// standing layer, in a model with momentum smoothed as it has them. Central differences, one-sided beside a border
// or no data.
glm::vec2 ground_slope(const sim::View& world, int x, int y);

// Speed along the slope of a velocity in plan on ground with tangents `slope`: √(|v|² + (slope·v)²).
double speed_along_slope(glm::dvec2 velocity, glm::dvec2 slope);

}  // namespace game
