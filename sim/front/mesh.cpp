#include "sim/front/mesh.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <tuple>
#include <utility>

#include <glm/geometric.hpp>

namespace sim::front {
namespace {

// Least height of a triangle as a share of its longest edge. Below it, rounding decides on which side a
// corner lies.
constexpr double kLeastHeight = 1e-6;
// m. Within these limits the fourth power of a length and its inverse are floats.
constexpr double kShortestEdge = 1e-6, kLongestEdge = 1e9;

std::optional<MeshFault> fault_of(const std::vector<glm::vec2>& position,
                                  const std::vector<std::array<int, 3>>& triangle) {
    const int count = static_cast<int>(position.size());
    for (int v = 0; v < count; ++v)
        if (!std::isfinite(position[v].x) || !std::isfinite(position[v].y))
            return MeshFault{MeshFault::Kind::kNotFinite, v};
    for (std::size_t t = 0; t < triangle.size(); ++t) {
        const auto& corner = triangle[t];
        const int number = static_cast<int>(t);
        if (std::any_of(corner.begin(), corner.end(), [&](int v) { return v < 0 || v >= count; }))
            return MeshFault{MeshFault::Kind::kNoSuchVertex, number};
        const glm::dvec2 p(position[corner[0]]), q(position[corner[1]]), r(position[corner[2]]);
        const glm::dvec2 u = q - p, w = r - p;
        const auto [shortest, longest] = std::minmax({glm::length(u), glm::length(w), glm::length(r - q)});
        if (!(std::abs(u.x * w.y - u.y * w.x) > kLeastHeight * longest * longest))
            return MeshFault{MeshFault::Kind::kDegenerate, number};
        if (!(shortest >= kShortestEdge && longest <= kLongestEdge))
            return MeshFault{MeshFault::Kind::kDegenerate, number};
    }
    return std::nullopt;
}

// Fills in what follows from positions, triangles and edges.
void finish(Mesh& mesh) {
    const auto vertices = mesh.position.size(), edges = mesh.edge.size();
    mesh.length.resize(edges);
    mesh.first_spoke.assign(vertices + 1, 0);
    for (std::size_t e = 0; e < edges; ++e) {
        mesh.length[e] = glm::length(mesh.along(static_cast<int>(e)));
        ++mesh.first_spoke[mesh.edge[e].a + 1], ++mesh.first_spoke[mesh.edge[e].b + 1];
    }
    for (std::size_t v = 0; v < vertices; ++v) mesh.first_spoke[v + 1] += mesh.first_spoke[v];
    mesh.spokes.resize(2 * edges);
    std::vector<int> next(mesh.first_spoke.begin(), mesh.first_spoke.end() - 1);
    for (int e = 0; e < mesh.edges(); ++e) {
        const auto [a, b] = mesh.edge[e];
        mesh.spokes[next[a]++] = {b, e}, mesh.spokes[next[b]++] = {a, e};
    }
    mesh.cell.assign(vertices, 0);
    for (int v = 0; v < mesh.vertices(); ++v) {
        const auto begin = mesh.spokes.begin() + mesh.first_spoke[v], end = mesh.spokes.begin() + next[v];
        std::sort(begin, end, [](const auto& x, const auto& y) { return x.vertex < y.vertex; });
        for (auto spoke = begin; spoke != end; ++spoke) {
            float& cell = mesh.cell[v];
            cell = cell == 0 ? mesh.length[spoke->edge] : std::min(cell, mesh.length[spoke->edge]);
        }
    }
    mesh.edge_triangle.assign(edges, {-1, -1});
    for (std::size_t t = 0; t < mesh.triangle.size(); ++t)
        for (const int e : mesh.triangle_edge[t])
            mesh.edge_triangle[e][mesh.edge_triangle[e][0] < 0 ? 0 : 1] = static_cast<int>(t);
}

}  // namespace

std::variant<Mesh, MeshFault> mesh_of(std::vector<glm::vec2> position,
                                      std::vector<std::array<int, 3>> triangle) {
    if (const auto fault = fault_of(position, triangle)) return *fault;
    // Sides of triangles, sorted so that those of one edge are adjacent.
    struct Side {
        int a, b, triangle, from;  // from: the corner where it begins
    };
    std::vector<Side> sides;
    sides.reserve(3 * triangle.size());
    for (std::size_t t = 0; t < triangle.size(); ++t)
        for (int k = 0; k < 3; ++k) {
            const auto [a, b] = std::minmax(triangle[t][k], triangle[t][(k + 1) % 3]);
            sides.push_back({a, b, static_cast<int>(t), k});
        }
    std::sort(sides.begin(), sides.end(), [](const Side& x, const Side& y) {
        return std::tie(x.a, x.b, x.triangle) < std::tie(y.a, y.b, y.triangle);
    });

    Mesh mesh;
    mesh.position = std::move(position);
    mesh.triangle = std::move(triangle);
    mesh.triangle_edge.resize(mesh.triangle.size());
    std::optional<MeshFault> fault;
    for (std::size_t i = 0; i < sides.size(); ++i) {
        const Side& side = sides[i];
        const auto same = [&](std::size_t j) { return sides[j].a == side.a && sides[j].b == side.b; };
        if (i == 0 || !same(i - 1)) mesh.edge.push_back({side.a, side.b});
        if (i >= 2 && same(i - 2) && (!fault || side.triangle < fault->where))
            fault = MeshFault{MeshFault::Kind::kTooManyTriangles, side.triangle};
        mesh.triangle_edge[side.triangle][side.from] = mesh.edges() - 1;
    }
    if (fault) return *fault;
    finish(mesh);
    return mesh;
}

Mesh mesh_of(const Grid& grid) {
    Mesh mesh;
    const int nx = grid.nx, ny = grid.ny;
    mesh.columns = nx;
    for (int y = 0; y < ny; ++y)
        for (int x = 0; x < nx; ++x)
            mesh.position.emplace_back(static_cast<float>(x) * grid.dx, static_cast<float>(y) * grid.dx);
    const auto add = [&](int columns, int rows, int step) {
        const int first = mesh.edges();
        for (int y = 0; y < rows; ++y)
            for (int x = 0; x < columns; ++x) mesh.edge.push_back({y * nx + x, y * nx + x + step});
        return first;
    };
    const int along_x = add(nx - 1, ny, 1), along_y = add(nx, ny - 1, nx);
    const int diagonal = add(nx - 1, ny - 1, nx + 1);
    for (int y = 0; y + 1 < ny; ++y)
        for (int x = 0; x + 1 < nx; ++x) {
            const int v = y * nx + x, below = along_x + y * (nx - 1) + x, left = along_y + y * nx + x;
            const int across = diagonal + y * (nx - 1) + x;
            mesh.triangle.push_back({v, v + 1, v + nx + 1});
            mesh.triangle_edge.push_back({below, left + 1, across});
            mesh.triangle.push_back({v, v + nx + 1, v + nx});
            mesh.triangle_edge.push_back({across, below + nx - 1, left});
        }
    finish(mesh);
    return mesh;
}

}  // namespace sim::front
