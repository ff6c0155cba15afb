#include "render/mountain/ground_mesh.h"

#include <algorithm>
#include <set>
#include <utility>

#include <gtest/gtest.h>

#include "assets/shaders/slots.glsl"
#include "tests/render/world.h"

namespace render {
namespace {

test::World flat(int squares) {
    return test::make_world(squares, 1, [](double, double) { return 0; });
}

GroundMesh mesh_of(const test::World& world) {
    return ground_mesh(world.grid, world.site);
}

using Edge = std::pair<std::uint32_t, std::uint32_t>;

// Directed edges of the surface whose other side is empty.
std::set<Edge> rim(const GroundMesh& mesh) {
    std::set<Edge> edges;
    for (std::size_t i = 0; i < mesh.surface.size(); i += 3) {
        for (std::size_t k = 0; k < 3; ++k)
            edges.insert({mesh.surface[i + k], mesh.surface[i + (k + 1) % 3]});
    }
    std::set<Edge> open;
    for (const Edge& edge : edges) {
        if (edges.count({edge.second, edge.first}) == 0) open.insert(edge);
    }
    return open;
}

TEST(GroundMesh, cuts_a_square_from_lower_left_to_upper_right) {
    const test::World world = test::make_world(2, 1, [](double, double) { return 0; });
    const GroundMesh mesh = mesh_of(world);
    ASSERT_EQ(mesh.surface.size(), 3u * 8);
    const std::vector<std::uint32_t> first(mesh.surface.begin(), mesh.surface.begin() + 6);
    EXPECT_EQ(first,
              (std::vector<std::uint32_t>{surface_index(0, 0), surface_index(1, 0), surface_index(1, 1),
                                          surface_index(0, 0), surface_index(1, 1), surface_index(0, 1)}));
}

TEST(GroundMesh, leaves_out_the_six_triangles_around_a_vertex_without_data) {
    test::World world = flat(4);
    world.site(2, 2) = sim::Site::kDrain;
    const GroundMesh mesh = mesh_of(world);
    EXPECT_EQ(mesh.surface.size(), 3u * (32 - 6));
    EXPECT_EQ(std::count(mesh.surface.begin(), mesh.surface.end(), surface_index(2, 2)), 0);
}

TEST(GroundMesh, draws_no_triangle_twice_on_a_grid_of_many_blocks) {
    const GroundMesh mesh = mesh_of(flat(30));
    std::set<std::vector<std::uint32_t>> triangles;
    for (std::size_t i = 0; i < mesh.surface.size(); i += 3)
        triangles.insert({mesh.surface[i], mesh.surface[i + 1], mesh.surface[i + 2]});
    EXPECT_EQ(triangles.size(), 2u * 30 * 30);
    EXPECT_EQ(mesh.surface.size(), 3u * 2 * 30 * 30);
}

TEST(GroundMesh, has_each_triangle_in_one_block_whose_corners_hold_it) {
    test::World world = flat(30);
    for (int y = 0; y <= 8; ++y)
        for (int x = 8; x <= 16; ++x) world.site(x, y) = sim::Site::kDrain;
    const GroundMesh mesh = mesh_of(world);
    EXPECT_EQ(mesh.blocks.size(), 15u);  // one is empty
    std::uint32_t next = 0;
    for (const GroundMesh::Block& block : mesh.blocks) {
        EXPECT_EQ(block.first, next);
        next += block.count;
        for (std::uint32_t i = block.first; i < next; ++i) {
            const int x = static_cast<int>(mesh.surface[i] & INDEX_X_MASK),
                      y = static_cast<int>(mesh.surface[i] >> INDEX_Y_SHIFT);
            EXPECT_TRUE(x >= block.lowest.x && x <= block.highest.x && y >= block.lowest.y &&
                        y <= block.highest.y);
        }
    }
    EXPECT_EQ(next, mesh.surface.size());
}

TEST(GroundMesh, has_one_wall_under_every_edge_where_the_surface_ends) {
    test::World world = flat(14);
    world.site(5, 6) = world.site(6, 6) = world.site(0, 14) = sim::Site::kDrain;
    const GroundMesh mesh = mesh_of(world);
    std::set<Edge> walls;
    for (std::size_t i = 0; i < mesh.walls.size(); i += 6) {
        const std::uint32_t from = mesh.walls[i + 5], to = mesh.walls[i + 2];
        EXPECT_EQ(mesh.walls[i], from | base_index(0, 0));
        EXPECT_EQ(mesh.walls[i + 1], to | base_index(0, 0));
        EXPECT_TRUE(walls.insert({from, to}).second);
    }
    EXPECT_EQ(walls, rim(mesh));
}

}  // namespace
}  // namespace render
