#pragma once

#include <array>
#include <optional>

#include <glm/vec2.hpp>

#include "sim/front/tracker.h"

// Reference for the remeshing shader: cuts the mesh along its fronts (section 4 of the paper), triangle by
// triangle. The shader must produce the same vertices.

namespace sim::front {

// Points are drawn at least this far from the ends of their edge, as a share of it. So the only triangles
// without area are those of a tear.
constexpr float kNearestToEnd = 0.01f;

struct CutVertex {
    glm::vec2 position;     // m
    int side;               // the mesh vertex itself, or the one whose side of the front this copy is on
    bool on_front = false;  // a copy on the front
};
using CutTriangle = std::array<CutVertex, 3>;

// The result of cutting a triangle: itself, or up to six that cover it, in the same orientation.
struct CutTriangles {
    std::array<CutTriangle, 6> triangle;
    int count = 0;

    const CutTriangle* begin() const { return triangle.data(); }
    const CutTriangle* end() const { return triangle.data() + count; }
};

// Cuts a triangle. `corner`: numbers of the vertices A, B, C, at the positions `at`. `crossing`: where the
// front crosses AB, BC and CA.
//
//     one cut            two cuts             three cuts
//
//         C                  A                    C
//        ╱|╲                ╱ ╲                 ╱ | ╲
//       ╱ | ╲              d···d               d  |  d
//      ╱  |  ╲            ╱  ╲   ╲             ╱ `m´ ╲
//     A---d---B          B-----╲--C           A---d---B
//
//     1: (C A dᴬ) (C dᴬ dᴮ) (C dᴮ B); the second has no area, because the tear ends there
//     2: the corner alone; the rest is split by its shorter diagonal
//     3: two triangles for each corner, around the mean m
CutTriangles cut_triangle(const std::array<int, 3>& corner, const std::array<glm::vec2, 3>& at,
                          const std::array<std::optional<glm::vec2>, 3>& crossing);

// Cuts a triangle of a tracker's mesh at its points, which are kept kNearestToEnd away from the ends.
CutTriangles cut_triangle(const Tracker& tracker, int triangle);

// Number of cut triangles.
int count_cut_triangles(const Tracker& tracker);

}  // namespace sim::front
