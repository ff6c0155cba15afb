#include "sim/front/remesh_reference.h"

#include <algorithm>
#include <vector>

namespace sim::front {
namespace {

// Multiply, because a shader need not round divisions well.
constexpr float kThird = 0.33333334f;

float squared_distance(const glm::vec2& p, const glm::vec2& q) {
    const glm::vec2 way = q - p;
    return way.x * way.x + way.y * way.y;
}

}  // namespace

CutTriangles cut_triangle(const std::array<int, 3>& corner, const std::array<glm::vec2, 3>& at,
                          const std::array<std::optional<glm::vec2>, 3>& crossing) {
    CutTriangles cut;
    const auto add = [&](const CutVertex& p, const CutVertex& q, const CutVertex& r) {
        cut.triangle[cut.count++] = {p, q, r};
    };
    const auto vertex = [&](int k) { return CutVertex{at[k], corner[k]}; };
    // The copy on the edge from corner k to the next, on the side of corner `side`.
    const auto copy = [&](int k, int side) { return CutVertex{*crossing[k], corner[side], true}; };

    const auto count =
        std::count_if(crossing.begin(), crossing.end(), [](const auto& d) { return d.has_value(); });
    if (count == 0) {
        add(vertex(0), vertex(1), vertex(2));
    } else if (count == 1) {
        const int a = crossing[0] ? 0 : crossing[1] ? 1 : 2, b = (a + 1) % 3, c = (a + 2) % 3;
        add(vertex(c), vertex(a), copy(a, a));
        add(vertex(c), copy(a, a), copy(a, b));
        add(vertex(c), copy(a, b), vertex(b));
    } else if (count == 2) {
        // A is alone between the two cut edges; BC is not cut.
        const int b = !crossing[0] ? 0 : !crossing[1] ? 1 : 2, c = (b + 1) % 3, a = (b + 2) % 3;
        add(vertex(a), copy(a, a), copy(c, a));
        const CutVertex d = copy(a, b), e = copy(c, c);
        if (squared_distance(d.position, at[c]) <= squared_distance(at[b], e.position)) {
            add(d, vertex(b), vertex(c));
            add(d, vertex(c), e);
        } else {
            add(d, vertex(b), e);
            add(vertex(b), vertex(c), e);
        }
    } else {
        const glm::vec2 mean = kThird * (*crossing[0] + *crossing[1] + *crossing[2]);
        for (int a = 0; a < 3; ++a) {
            const CutVertex middle{mean, corner[a], true};
            add(vertex(a), copy(a, a), middle);
            add(vertex(a), middle, copy((a + 2) % 3, a));
        }
    }
    return cut;
}

CutTriangles cut_triangle(const Tracker& tracker, int triangle) {
    const Mesh& mesh = tracker.mesh();
    std::array<glm::vec2, 3> at;
    std::array<std::optional<glm::vec2>, 3> crossing;
    for (int k = 0; k < 3; ++k) {
        at[k] = mesh.position[mesh.triangle[triangle][k]];
        const int edge = mesh.triangle_edge[triangle][k], slot = tracker.detector().slot(edge);
        if (slot < 0) continue;
        // Measured from the edge's vertex a, so that both adjacent triangles get bit-identical points.
        Point point = tracker.points()[slot];
        point.f = std::clamp(point.f, kNearestToEnd, 1 - kNearestToEnd);
        crossing[k] = tracker.position(point);
    }
    return cut_triangle(mesh.triangle[triangle], at, crossing);
}

int count_cut_triangles(const Tracker& tracker) {
    std::vector<int> beside;
    for (const int edge : tracker.detector().cut())
        for (const int t : tracker.mesh().edge_triangle[edge])
            if (t >= 0) beside.push_back(t);
    std::sort(beside.begin(), beside.end());
    return static_cast<int>(std::unique(beside.begin(), beside.end()) - beside.begin());
}

}  // namespace sim::front
