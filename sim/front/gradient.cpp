#include "sim/front/gradient.h"

#include "sim/front/least_squares.h"

namespace sim::front {

glm::mat2 gradient_at(const Detector& detector, int vertex, std::span<const glm::vec2> coordinates,
                      const glm::mat2& last) {
    const Mesh& mesh = detector.mesh();
    LeastSquares u, v;  // by how much G differs from the last: the shortest solution stays nearest to it
    for (const auto& spoke : mesh.around(vertex)) {
        if (detector.is_cut(spoke.edge)) continue;
        const glm::vec2 way = mesh.position[spoke.vertex] - mesh.position[vertex];
        const glm::vec2 beyond = coordinates[spoke.vertex] - coordinates[vertex] - last * way;
        u.add(glm::dvec2(way), beyond.x);
        v.add(glm::dvec2(way), beyond.y);
    }
    const glm::dvec2 du = u.solve(), dv = v.solve();
    return last + glm::mat2(du.x, dv.x, du.y, dv.y);
}

}  // namespace sim::front
