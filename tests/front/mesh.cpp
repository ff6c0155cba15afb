#include "sim/front/mesh.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <set>

namespace {

using sim::front::Mesh;
using sim::front::mesh_of;
using sim::front::MeshFault;

using Triangles = std::vector<std::array<int, 3>>;

const std::vector<glm::vec2> kSquare{{0, 0}, {1, 0}, {0, 1}, {1, 1}};

MeshFault fault_of(std::vector<glm::vec2> position, Triangles triangle) {
    const auto made = mesh_of(std::move(position), std::move(triangle));
    EXPECT_TRUE(std::holds_alternative<MeshFault>(made));
    return std::get<MeshFault>(made);
}

// Checks what must hold for any mesh.
void expect_whole(const Mesh& mesh) {
    ASSERT_EQ(mesh.triangle.size(), mesh.triangle_edge.size());
    std::vector<int> uses(mesh.edge.size());
    for (std::size_t t = 0; t < mesh.triangle.size(); ++t)
        for (int k = 0; k < 3; ++k) {
            const int e = mesh.triangle_edge[t][k];
            const auto [a, b] = std::minmax(mesh.triangle[t][k], mesh.triangle[t][(k + 1) % 3]);
            EXPECT_EQ(mesh.edge[e].a, a);
            EXPECT_EQ(mesh.edge[e].b, b);
            EXPECT_TRUE(mesh.edge_triangle[e][0] == static_cast<int>(t) ||
                        mesh.edge_triangle[e][1] == static_cast<int>(t));
            ++uses[e];
        }
    for (int e = 0; e < mesh.edges(); ++e) {
        EXPECT_EQ(uses[e], 1 + (mesh.edge_triangle[e][1] >= 0));
        EXPECT_GT(mesh.length[e], 0);
    }
    std::size_t spokes = 0;
    for (int v = 0; v < mesh.vertices(); ++v) {
        float shortest = std::numeric_limits<float>::infinity();
        for (const auto& spoke : mesh.around(v)) {
            const auto [a, b] = mesh.edge[spoke.edge];
            EXPECT_EQ(spoke.vertex, a == v ? b : a);
            shortest = std::min(shortest, mesh.length[spoke.edge]);
            ++spokes;
        }
        EXPECT_EQ(mesh.cell[v], shortest);
        EXPECT_TRUE(std::is_sorted(mesh.around(v).begin(), mesh.around(v).end(),
                                   [](const auto& x, const auto& y) { return x.vertex < y.vertex; }));
    }
    EXPECT_EQ(spokes, 2 * mesh.edge.size());
}

TEST(Mesh, of_triangles_finds_its_edges) {
    const auto made = mesh_of(kSquare, {{0, 1, 3}, {0, 3, 2}});
    ASSERT_TRUE(std::holds_alternative<Mesh>(made));
    const Mesh& mesh = std::get<Mesh>(made);
    EXPECT_EQ(mesh.edges(), 5);
    EXPECT_EQ(mesh.columns, 0);
    expect_whole(mesh);
}

TEST(Mesh, of_triangles_may_have_parts_holes_and_any_orientation) {
    std::vector<glm::vec2> position = kSquare;
    for (const glm::vec2& p : kSquare) position.emplace_back(p.x + 5, p.y);
    const auto made = mesh_of(position, {{0, 1, 3}, {3, 0, 2}, {4, 5, 6}});
    ASSERT_TRUE(std::holds_alternative<Mesh>(made));
    EXPECT_EQ(std::get<Mesh>(made).around(7).size(), 0u);
}

TEST(Mesh, of_a_heightfield_is_the_mesh_of_its_triangles) {
    const Mesh field = mesh_of(sim::Grid{5, 4, 2});
    expect_whole(field);
    EXPECT_EQ(field.columns, 5);
    EXPECT_EQ(field.edges(), 4 * 4 + 5 * 3 + 4 * 3);
    const auto made = mesh_of(field.position, field.triangle);
    ASSERT_TRUE(std::holds_alternative<Mesh>(made));
    const Mesh& mesh = std::get<Mesh>(made);
    const auto edges_of = [](const Mesh& of) {
        std::set<std::pair<int, int>> edges;
        for (const auto& edge : of.edge) edges.emplace(edge.a, edge.b);
        return edges;
    };
    EXPECT_EQ(edges_of(field), edges_of(mesh));
}

TEST(Mesh, rejects_invalid_triangles) {
    using Kind = MeshFault::Kind;
    const float infinite = std::numeric_limits<float>::infinity(),
                none = std::numeric_limits<float>::quiet_NaN();
    for (const float wrong : {infinite, -infinite, none}) {
        const MeshFault fault = fault_of({{0, 0}, {1, 0}, {0, wrong}}, {{0, 1, 2}});
        EXPECT_EQ(fault.kind, Kind::kNotFinite);
        EXPECT_EQ(fault.where, 2);
    }
    for (const int wrong : {-1, 4, std::numeric_limits<int>::max()}) {
        const MeshFault fault = fault_of(kSquare, {{0, 1, 3}, {0, wrong, 2}});
        EXPECT_EQ(fault.kind, Kind::kNoSuchVertex);
        EXPECT_EQ(fault.where, 1);
    }
    EXPECT_EQ(fault_of(kSquare, {{0, 1, 1}}).kind, Kind::kDegenerate);
    EXPECT_EQ(fault_of({{0, 0}, {1, 1}, {2, 2}}, {{0, 1, 2}}).kind, Kind::kDegenerate);
    EXPECT_EQ(fault_of({{0, 0}, {0, 0}, {2, 2}}, {{0, 1, 2}}).kind, Kind::kDegenerate);
    // The squares of such lengths are not representable as floats.
    for (const float side : {1e-31f, 1e-23f, 1e-7f, 1e10f, 1e30f})
        EXPECT_EQ(fault_of({{0, 0}, {side, 0}, {0, side}}, {{0, 1, 2}}).kind, Kind::kDegenerate) << side;
    const MeshFault fan =
        fault_of({{0, 0}, {1, 0}, {0, 1}, {0, 2}, {0, 3}}, {{0, 1, 2}, {0, 1, 3}, {0, 1, 4}});
    EXPECT_EQ(fan.kind, Kind::kTooManyTriangles);
    EXPECT_EQ(fan.where, 2);
}

}  // namespace
