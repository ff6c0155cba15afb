#include "sim/front/upstream.h"

#include <algorithm>
#include <cmath>

namespace sim::front {
namespace {

float cross(const glm::vec2& a, const glm::vec2& b) {
    return a.x * b.y - a.y * b.x;
}

// Barycentric coordinates in a triangle of either orientation; negative beyond the edge opposite to a corner.
std::array<float, 3> weights_at(const Mesh& mesh, int triangle, const glm::vec2& at) {
    const auto& corner = mesh.triangle[triangle];
    const glm::vec2 a = mesh.position[corner[0]], ab = mesh.position[corner[1]] - a,
                    ac = mesh.position[corner[2]] - a, way = at - a;
    const float area = cross(ab, ac), b = cross(way, ac) / area, c = cross(ab, way) / area;
    return {1 - b - c, b, c};
}

}  // namespace

Upstream::Upstream(const Mesh& mesh) : mesh_(mesh) {
    if (mesh.columns > 0) cell_ = mesh.length[0];
    first_.assign(mesh.position.size() + 1, 0);
    for (const auto& corner : mesh.triangle)
        for (const int v : corner) ++first_[v + 1];
    for (std::size_t v = 1; v < first_.size(); ++v) first_[v] += first_[v - 1];
    fans_.resize(3 * mesh.triangle.size());
    std::vector<int> next(first_.begin(), first_.end() - 1);
    for (std::size_t t = 0; t < mesh.triangle.size(); ++t)
        for (const int v : mesh.triangle[t]) fans_[next[v]++] = static_cast<int>(t);
}

std::optional<PlaceIn> Upstream::find(int vertex, const glm::vec2& way,
                                      std::span<const std::uint8_t> torn) const {
    const bool near = mesh_.columns > 0 && std::max(std::abs(way.x), std::abs(way.y)) <= cell_;
    return near ? find_in_square(vertex, way, torn) : walk(vertex, way, torn);
}

// A square of a heightfield is found by its number. From a corner off its diagonal the way may lead through
// both triangles.
std::optional<PlaceIn> Upstream::find_in_square(int vertex, const glm::vec2& way,
                                                std::span<const std::uint8_t> torn) const {
    const int columns = mesh_.columns, rows = mesh_.vertices() / columns;
    const int left = vertex % columns - (way.x < 0), below = vertex / columns - (way.y < 0);
    if (left < 0 || below < 0 || left > columns - 2 || below > rows - 2) {
        // A vertex on the border may have no square on that side.
        return walk(vertex, way, torn);
    }
    const float fx = (way.x < 0) + way.x / cell_, fy = (way.y < 0) + way.y / cell_;
    const bool lower = fx >= fy;
    const int triangle = 2 * (below * (columns - 1) + left) + !lower;
    const bool on_diagonal = (way.x < 0) == (way.y < 0), begins_lower = way.x < 0;
    if (torn[triangle] || (!on_diagonal && begins_lower != lower && torn[triangle ^ 1])) return std::nullopt;
    if (lower) return PlaceIn{triangle, {1 - fx, fx - fy, fy}};
    return PlaceIn{triangle, {1 - fy, fx, fy - fx}};
}

// Starts in the triangle at the vertex into which the way leads, and walks on through edges.
std::optional<PlaceIn> Upstream::walk(int vertex, const glm::vec2& way,
                                      std::span<const std::uint8_t> torn) const {
    const glm::vec2 from = mesh_.position[vertex], to = from + way;
    int triangle = -1;
    for (const int t : fan(vertex)) {
        // Beyond none of the edges that meet at the vertex.
        const auto weight = weights_at(mesh_, t, to);
        bool leads_into = true;
        for (int k = 0; k < 3; ++k)
            leads_into = leads_into && (mesh_.triangle[t][k] == vertex || weight[k] >= 0);
        if (leads_into) triangle = t;
    }
    for (int came_from = -1; triangle >= 0 && !torn[triangle];) {
        const auto weight = weights_at(mesh_, triangle, to);
        if (std::all_of(weight.begin(), weight.end(), [](float w) { return w >= 0; }))
            return PlaceIn{triangle, weight};
        // Leave through the edge that the way meets first: the target is beyond it, and its ends are on
        // either side of the way.
        int through = -1;
        for (int k = 0; k < 3; ++k) {
            const int edge = mesh_.triangle_edge[triangle][k];
            const auto [a, b] = mesh_.edge[edge];
            const float left = cross(way, mesh_.position[a] - from),
                        right = cross(way, mesh_.position[b] - from);
            if (weight[(k + 2) % 3] < 0 && edge != came_from && left * right <= 0) through = edge;
        }
        if (through < 0) return std::nullopt;
        const auto [one, other] = mesh_.edge_triangle[through];
        triangle = one == triangle ? other : one;
        came_from = through;
    }
    return std::nullopt;
}

}  // namespace sim::front
