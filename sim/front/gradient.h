#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <span>

#include <glm/mat2x2.hpp>
#include <glm/vec2.hpp>

#include "sim/front/detector.h"
#include "sim/front/least_squares.h"

namespace sim::front {

// Computes the gradients of N sets of coordinates at a vertex, from neighbours across uncut edges: for each
// set the least-squares solution of c_k − c_j = G (x_k − x_j), equations (9) and (10) of the paper. On entry
// `gradient` holds the fallback for directions that the neighbours leave undetermined: the gradient of the
// previous step, or that of coordinates at rest. Columns: ∂c/∂x and ∂c/∂y, per m. `coordinates`: one array
// for each vertex.
template <std::size_t N>
void find_gradients(const Detector& detector, int vertex,
                    std::span<const std::array<glm::vec2, N>> coordinates,
                    std::array<glm::mat2, N>& gradient) {
    const Mesh& mesh = detector.mesh();
    LeastSquares rows;  // one matrix for all sets
    for (const auto& spoke : mesh.around(vertex))
        if (!detector.is_cut(spoke.edge))
            rows.add(glm::dvec2(mesh.position[spoke.vertex] - mesh.position[vertex]), 0);
    const glm::mat2 inverse(rows.inverse());

    // Change against the fallback: the shortest solution stays nearest to it.
    std::array<glm::mat2, N> change{};
    for (const auto& spoke : mesh.around(vertex)) {
        if (detector.is_cut(spoke.edge)) continue;
        const glm::vec2 way = mesh.position[spoke.vertex] - mesh.position[vertex], weight = inverse * way;
        for (std::size_t i = 0; i < N; ++i) {
            const glm::vec2 beyond =
                coordinates[spoke.vertex][i] - coordinates[vertex][i] - gradient[i] * way;
            change[i][0] += beyond * weight.x;
            change[i][1] += beyond * weight.y;
        }
    }
    for (std::size_t i = 0; i < N; ++i) gradient[i] += change[i];
}

// Greatest and least stretch by a gradient; the least is below 0 if the gradient turns the texture over.
template <class T>
struct SingularValues {
    T greatest, least;
};
template <class T>
SingularValues<T> singular_values(const glm::mat<2, 2, T>& g) {
    const T same = std::hypot(g[0].x + g[1].y, g[0].y - g[1].x) / 2;
    const T other = std::hypot(g[0].x - g[1].y, g[0].y + g[1].x) / 2;
    return {same + other, same - other};
}

// Coordinates extrapolated from a vertex by its gradient, equation (9).
inline glm::vec2 carried_on(const glm::vec2& coordinates, const glm::mat2& gradient, const glm::vec2& way) {
    return coordinates + gradient * way;
}

}  // namespace sim::front
