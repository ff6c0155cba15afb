#pragma once

#include <span>

#include <glm/vec2.hpp>

#include "sim/world/state.h"

namespace sim::carried {

// The surface at a place between four vertices.
struct GroundAt {
    float surface;       // height, m above the datum
    float flow;          // depth of the rolling layer, m
    float loose;         // depth of the standing layer above that of tick 0, m; below 0: it was eroded
    glm::vec2 velocity;  // of the rolling layer, m/s
    glm::vec2 slope;     // rise of the surface over a metre along x and y
    bool outside;        // of the grid: then the nearest place on its border
};

// Interpolates between vertices. `first_depth`: of the standing layer at tick 0, m, one value per vertex, or none. `at`: m.
GroundAt ground_at(const View& world, std::span<const float> first_depth, glm::vec2 at);

}  // namespace sim::carried
