#pragma once

#include <span>

#include <glm/mat2x2.hpp>
#include <glm/vec2.hpp>

#include "sim/front/detector.h"

namespace sim::front {

// How coordinates change around a vertex, from the neighbours that no front separates from it: the
// least-squares solution of c_k − c_j = G (x_k − x_j) (equations 9 and 10 of the paper). Of what the
// neighbours leave open, since there is none or they lie on one line, `last` decides: the gradient of the
// step before, or that of coordinates at rest. Columns: ∂c/∂x and ∂c/∂y, per m. `coordinates`: one for each
// vertex.
glm::mat2 gradient_at(const Detector& detector, int vertex, std::span<const glm::vec2> coordinates,
                      const glm::mat2& last);

// Coordinates carried on from a vertex with its gradient, to the front or beyond.
inline glm::vec2 carried_on(const glm::vec2& coordinates, const glm::mat2& gradient, const glm::vec2& way) {
    return coordinates + gradient * way;
}

}  // namespace sim::front
