#pragma once

#include <array>
#include <optional>

#include <glm/vec2.hpp>

#include "sim/front/tracker.h"

// The mesh cut along its fronts (section 4 of the paper), triangle by triangle, as a shader is to cut it:
// what it must equal, vertex by vertex.

namespace sim::front {

// Points are drawn no nearer than this to the ends of their edge, as a share of it, so that no triangle but
// a tear's is without area.
constexpr float kNearestToEnd = 0.01f;

struct CutVertex {
    glm::vec2 position;  // m
    int side;  // the vertex of the mesh itself, or the one whose side of the front this copy lies on
    bool on_front = false;  // a copy on the front
};
using CutTriangle = std::array<CutVertex, 3>;

// What becomes of a triangle: itself, or up to six that cover it and are turned as it is.
struct CutTriangles {
    std::array<CutTriangle, 6> triangle;
    int count = 0;

    const CutTriangle* begin() const { return triangle.data(); }
    const CutTriangle* end() const { return triangle.data() + count; }
};

// `corner`: numbers of the vertices A, B, C, at the positions `at`; `crossing`: where the front crosses AB,
// BC and CA.
//
//     one cut            two cuts             three cuts
//
//         C                  A                    C
//        /|\                / \                 / | \           1: (C A dᴬ) (C dᴬ dᴮ) (C dᴮ B), the second
//       / | \              d···d               d  |  d             without area, for the tear ends there
//      /  |  \            /  \   \             / `m´ \          2: the corner; the rest by its shorter
//      diagonal
//     A---d---B          B-----\--C           A---d---B         3: two for each corner, about the mean m
CutTriangles cut_triangle(const std::array<int, 3>& corner, const std::array<glm::vec2, 3>& at,
                          const std::array<std::optional<glm::vec2>, 3>& crossing);

// A triangle of a tracker's mesh, cut at its points, which are kept kNearestToEnd away from the ends.
CutTriangles cut_triangle(const Tracker& tracker, int triangle);

// How many triangles are cut.
int count_cut_triangles(const Tracker& tracker);

}  // namespace sim::front
