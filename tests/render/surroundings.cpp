#include "render/mountain/surroundings.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

#include <gtest/gtest.h>

#include "render/mountain/surroundings_mesh.h"
#include "tests/render/mountains.h"

// Mountains made from the ground that they surround; without GL.
namespace render::test {
namespace {

constexpr double kPi = 3.14159265358979;

double valley(double x, double y) {
    return 0.4 * std::abs(y - 250) + 30 * std::sin(x / 60) * std::cos(y / 45);
}

// Ground at its border, to look across: 4 × 80 places with the outward normal.
template <class Visit>
void along_the_border(const Surroundings& around, const Visit& visit) {
    const glm::dvec2 size = around.size();
    for (int i = 1; i < 80; ++i) {
        const double share = i / 80.0;
        visit(glm::dvec2(0, share * size.y), glm::dvec2(-1, 0));
        visit(glm::dvec2(size.x, share * size.y), glm::dvec2(1, 0));
        visit(glm::dvec2(share * size.x, 0), glm::dvec2(0, -1));
        visit(glm::dvec2(share * size.x, size.y), glm::dvec2(0, 1));
    }
}

TEST(Surroundings, meet_the_grid_without_a_step_and_without_a_crease) {
    const World world = make_world(100, 5, valley);
    const Surroundings around = mountains_around(world);
    along_the_border(around, [&](glm::dvec2 at, glm::dvec2 outward) {
        const auto height = [&](double out) { return around.height(at + out * outward); };
        EXPECT_NEAR(height(1e-6), height(0), 1e-4);
        const double inside = (height(0) - height(-2)) / 2, outside = (height(2) - height(1e-6)) / 2;
        // A slope that rises outward becomes gentle, or it would be a wall.
        if (inside < 0.1)
            EXPECT_NEAR(outside, inside, 0.25) << at.x << " " << at.y;
        else
            EXPECT_TRUE(outside > 0 && outside < inside + 0.1) << at.x << " " << at.y << ": " << outside;
    });
}

TEST(Surroundings, put_no_wall_before_the_grid) {
    const World world = make_world(100, 5, valley);
    const Surroundings around = mountains_around(world);
    along_the_border(around, [&](glm::dvec2 at, glm::dvec2 outward) {
        for (const double out : {5.0, 20.0, 80.0, 200.0})
            EXPECT_LE(around.height(at + out * outward), around.height(at) + 0.02 * 200 + 0.17 * out);
    });
}

TEST(Surroundings, rise_to_ranges_and_end) {
    const World world = make_world(100, 5, valley);
    const Surroundings around = mountains_around(world);
    double lowest = 1e9, highest = -1e9;
    for (int i = 0; i < 360; ++i) {
        const double z = around.height(glm::dvec2(250) +
                                       1500.0 * glm::dvec2(std::cos(i * kPi / 180), std::sin(i * kPi / 180)));
        lowest = std::min(lowest, z);
        highest = std::max(highest, z);
    }
    EXPECT_GT(highest - lowest, 40) << "three sides away there is no range";
    EXPECT_LE(highest, around.highest());
}

TEST(Surroundings, fill_holes_from_their_rim) {
    World world = make_world(40, 5, [](double x, double) { return x; });
    for (int y = 10; y < 30; ++y)
        for (int x = 10; x < 30; ++x) {
            world.site(x, y) = sim::Site::kDrain;
            world.bedrock(x, y) = -9999;
        }
    const Surroundings around = mountains_around(world);
    for (double x = 50; x <= 145; x += 5) EXPECT_NEAR(around.height({x, 100}), x, 12) << x;
}

TEST(Surroundings, are_as_rough_in_a_hole_as_the_ground_around_it) {
    World world = make_world(120, 5, [](double x, double y) {
        return 0.4 * x + 14 * std::sin(x / 22) * std::cos(y / 17) + 4 * std::sin(x / 7 + y / 9);
    });
    for (int y = 0; y <= 120; ++y)
        for (int x = 60; x <= 120; ++x) world.site(x, y) = sim::Site::kDrain;
    const Surroundings around = mountains_around(world);
    const auto roughness = [&](double from, double to) {
        double sum = 0;
        int count = 0;
        for (double y = 50; y <= 550; y += 5)
            for (double x = from; x <= to; x += 5, ++count)
                sum += std::abs(around.height({x - 15, y}) - 2 * around.height({x, y}) +
                                around.height({x + 15, y}));
        return sum / count;
    };
    const double known = roughness(50, 250), invented = roughness(370, 550);
    EXPECT_GT(invented, 0.4 * known);
    EXPECT_LT(invented, 2.5 * known);
}

// The height of a mesh's surface above a place outside the grid, by the triangle there.
std::optional<double> mesh_height(const SurroundingsMesh& mesh, glm::dvec2 at) {
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
        const glm::dvec3 a(mesh.vertices[mesh.indices[i]].at), b(mesh.vertices[mesh.indices[i + 1]].at),
            c(mesh.vertices[mesh.indices[i + 2]].at);
        const auto area = [](glm::dvec2 u, glm::dvec2 v, glm::dvec2 w) {
            return (v.x - u.x) * (w.y - u.y) - (v.y - u.y) * (w.x - u.x);
        };
        const double of_a = area(at, b, c), of_b = area(at, c, a), of_c = area(at, a, b);
        if (of_a < 0 || of_b < 0 || of_c < 0) continue;
        return (of_a * a.z + of_b * b.z + of_c * c.z) / (of_a + of_b + of_c);
    }
    return std::nullopt;
}

TEST(Surroundings, have_crests_without_needles) {
    // A sharp crest that leaves the grid over its eastern border. On the ground it changes slowly; a mesh that cuts
    // it has a gap between each two rings.
    const World world = make_world(160, 12.5, [](double, double y) { return 900 - std::abs(y - 1812); });
    const Surroundings around = mountains_around(world);
    const SurroundingsMesh mesh = surroundings_mesh(around);
    std::vector<double> crest;
    for (double x = 2030; x < 2500; x += 9) {
        double highest = 0;
        for (double y = 1770; y < 1850; y += 2)
            highest = std::max(highest, mesh_height(mesh, {x, y}).value_or(0));
        crest.push_back(highest);
    }
    double bends = 0;
    for (std::size_t i = 1; i + 1 < crest.size(); ++i)
        bends = std::max(bends, std::abs(crest[i - 1] - 2 * crest[i] + crest[i + 1]));
    EXPECT_LT(bends, 8) << "m in steps of 9 m";
}

TEST(Surroundings, are_covered_like_the_grid_at_their_height) {
    // Snow above a line, and a bare patch in it.
    World world = make_world(100, 5, [](double x, double y) { return 0.5 * x + 10 * std::sin(y / 40); });
    for (int y = 0; y <= 100; ++y)
        for (int x = 0; x <= 100; ++x)
            world.depth(x, y) = world.bedrock(x, y) > 125 && std::hypot(x - 80, y - 50) > 6 ? 1.f : 0.f;
    const Surroundings around = mountains_around(world);
    const auto depth_at_source = [&](glm::dvec2 at) {
        const glm::ivec2 v(around.source(at) / around.cell() + 0.5);
        return static_cast<double>(
            around.cover()[static_cast<std::size_t>(v.y) * 101 + static_cast<std::size_t>(v.x)].x);
    };
    int high = 0, low = 0;
    double on_high = 0, on_low = 0;
    for (double x = -240; x < 740; x += 11)
        for (double y = -240; y < 740; y += 11) {
            const glm::dvec2 at(x, y);
            if (around.away(at) == 0) continue;
            const double depth = std::clamp(depth_at_source(at) + around.cover_by_height(at).x, 0.0, 1.0);
            const double z = around.height(at);
            if (z > 150) on_high += depth, ++high;
            if (z < 100) on_low += depth, ++low;
        }
    ASSERT_GT(std::min(high, low), 100);
    EXPECT_GT(on_high / high, 0.9);
    EXPECT_LT(on_low / low, 0.1);
}

TEST(Surroundings, know_what_lies_at_the_surface_of_two_materials) {
    const World world = make_world(10, 5, [](double x, double) { return x; });
    std::vector<float> bedrock(121, 0), depth(121, 1), lower(121, 0.5f);
    lower[0] = 1;
    lower[1] = 0.975f;
    const Surroundings around(world.grid, bedrock, depth, std::vector<std::uint8_t>(121, 1), lower);
    EXPECT_EQ(around.cover()[0], glm::vec2(1, 1));
    EXPECT_NEAR(around.cover()[1].y, 0.5, 1e-4);
    EXPECT_EQ(around.cover()[2], glm::vec2(1, 0));
}

TEST(Surroundings, need_ground) {
    World world = make_world(10, 5, [](double, double) { return 0; });
    world.site.fill(sim::Site::kDrain);
    const Surroundings around = mountains_around(world);
    EXPECT_TRUE(around.empty());
    EXPECT_TRUE(surroundings_mesh(around).vertices.empty());
    EXPECT_FALSE(around.meet({0, 0, 100}, {0, 0, -1}));
    EXPECT_TRUE(Surroundings().empty());
}

TEST(Surroundings, are_told_apart_by_all_that_they_are_made_of) {
    World world = make_world(10, 5, [](double, double) { return 0; });
    const auto first = mountains_around(world).fingerprint();
    EXPECT_EQ(mountains_around(world).fingerprint(), first);
    world.depth(10, 10) = 0.01f;
    const auto second = mountains_around(world).fingerprint();
    EXPECT_NE(second, first);
    world.site(3, 3) = sim::Site::kDrain;
    const auto third = mountains_around(world).fingerprint();
    EXPECT_NE(third, second);
    EXPECT_NE(mountains_around(make_world(10, 6, [](double, double) { return 0; })).fingerprint(), first);
}

TEST(Surroundings, meet_a_ray_at_their_surface) {
    const World world = make_world(100, 5, valley);
    const Surroundings around = mountains_around(world);
    int met = 0;
    for (int i = 0; i < 200; ++i) {
        const glm::dvec3 along =
            glm::normalize(glm::dvec3(std::cos(0.7 * i), std::sin(0.7 * i), -0.01 - 0.004 * i));
        const glm::dvec3 from(250, 250, 400);
        const auto t = around.meet(from, along);
        if (!t) continue;
        const glm::dvec3 at = from + *t * along;
        EXPECT_GT(around.away(at), 0);
        EXPECT_NEAR(at.z, around.height(at), 0.05);
        ++met;
    }
    EXPECT_GT(met, 80);
    EXPECT_FALSE(around.meet({250, 250, 400}, glm::normalize(glm::dvec3(1, 0, 0.5))));
    // The ray ends on the grid, not on mountains.
    EXPECT_FALSE(around.meet({250, 250, 400}, {0, 0, -1}));
}

// Counts how often each edge of the mesh is used in each direction.
std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges_of(const SurroundingsMesh& mesh) {
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3)
        for (std::size_t k = 0; k < 3; ++k) ++edges[{mesh.indices[i + k], mesh.indices[i + (k + 1) % 3]}];
    return edges;
}

void expect_no_gap(const Surroundings& around, int border_edges) {
    const SurroundingsMesh mesh = surroundings_mesh(around);
    const auto edges = edges_of(mesh);
    int at_the_grid = 0;
    for (const auto& [edge, count] : edges) {
        EXPECT_EQ(count, 1) << "two triangles lie on each other";
        if (edges.contains({edge.second, edge.first})) continue;
        // An edge without a neighbour lies along the grid, or where the surroundings end.
        const glm::dvec2 a(mesh.vertices[edge.first].at), b(mesh.vertices[edge.second].at);
        const double end = Surroundings::kReach * around.side();
        const bool ends = around.away(a) > end - 1 && around.away(b) > end - 1;
        const bool grid = around.away(a) == 0 && around.away(b) == 0;
        EXPECT_TRUE(ends || grid) << a.x << " " << a.y;
        at_the_grid += grid;
    }
    EXPECT_EQ(at_the_grid, border_edges);
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
        const glm::dvec2 a(mesh.vertices[mesh.indices[i]].at), b(mesh.vertices[mesh.indices[i + 1]].at),
            c(mesh.vertices[mesh.indices[i + 2]].at);
        EXPECT_GT((b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x), 0)
            << "seen from above it is turned away";
    }
    for (const SurroundingsVertex& v : mesh.vertices) {
        EXPECT_TRUE(std::isfinite(v.at.z + v.slope.x + v.slope.y));
        EXPECT_TRUE(v.open > 0 && v.open <= 1.0001f) << v.open;
    }
    std::size_t drawn = 0;
    for (const SurroundingsPatch& patch : mesh.patches) drawn += patch.count;
    EXPECT_EQ(drawn, mesh.indices.size());
}

TEST(Surroundings, leave_no_gap) {
    expect_no_gap(mountains_around(make_world(60, 5, valley)), 4 * 60);
}

TEST(Surroundings, leave_no_gap_round_a_strip_two_squares_wide) {
    expect_no_gap(mountains_around(make_strip(3, 2001)), 2 * (2 + 2000));
}

TEST(Surroundings, leave_no_gap_where_the_border_has_holes) {
    World world = make_world(20, 5, valley);
    for (int y = 0; y < 4; ++y)
        for (int x = 5; x < 9; ++x) world.site(x, y) = sim::Site::kDrain;
    // The hole touches the border with its southern side: five edges there belong to it and not to the ground. Its
    // other edges are those of the ground's triangles.
    const Surroundings around = mountains_around(world);
    const SurroundingsMesh mesh = surroundings_mesh(around);
    const auto edges = edges_of(mesh);
    for (int x = 4; x < 9; ++x) {
        int with_both_sides = 0;
        for (const auto& [edge, count] : edges) {
            const glm::dvec2 a(mesh.vertices[edge.first].at), b(mesh.vertices[edge.second].at);
            if (a == glm::dvec2(5 * x, 0) && b == glm::dvec2(5 * x + 5, 0))
                with_both_sides = edges.contains({edge.second, edge.first});
        }
        EXPECT_TRUE(with_both_sides) << x;
    }
}

TEST(Surroundings, lie_in_the_shade_of_the_grid) {
    // A wall in the middle of level ground, the sun in the west.
    const World world = make_world(100, 5, [](double x, double) { return std::abs(x - 450) < 3 ? 200 : 0; });
    const Surroundings around = mountains_around(world);
    std::vector<SurroundingsVertex> places(2);
    places[0].at = glm::vec3(515, 250, around.height({515, 250}));
    places[1].at = glm::vec3(-15, 250, around.height({-15, 250}));
    std::vector<float> light;
    sunlit(around, places, glm::normalize(glm::dvec3(-1, 0, 0.5)), light);
    EXPECT_LT(light[0], 0.1f);
    EXPECT_GT(light[1], 0.9f);
}

TEST(Surroundings, are_drawn_from_near_to_far_where_a_camera_sees_them) {
    const World world = make_world(60, 5, valley);
    const SurroundingsMesh mesh = surroundings_mesh(mountains_around(world));
    for (int i = 0; i < 24; ++i) {
        Camera camera;
        camera.target = {150, 150, 50};
        camera.azimuth_deg = 15 * i;
        camera.elevation_deg = i % 2 ? 8 : 50;
        camera.distance_m = 400;
        const glm::dmat4 clip = projection_matrix(camera, 1.6) * view_matrix(camera);
        std::vector<const SurroundingsPatch*> visible;
        visible_patches(mesh.patches, OnScreen(clip, 160, 100), eye(camera), visible);
        EXPECT_LT(visible.size(), mesh.patches.size()) << "nothing is left out";
        for (const SurroundingsPatch& patch : mesh.patches) {
            if (std::find(visible.begin(), visible.end(), &patch) != visible.end()) continue;
            for (std::uint32_t k = patch.first; k < patch.first + patch.count; ++k) {
                const glm::dvec4 p = clip * glm::dvec4(mesh.vertices[mesh.indices[k]].at, 1);
                EXPECT_FALSE(p.w > 0 && std::abs(p.x) < p.w && std::abs(p.y) < p.w)
                    << "a visible vertex is left out";
            }
        }
        const auto distance = [&](const SurroundingsPatch* patch) {
            const glm::dvec3 from = eye(camera);
            return glm::distance(from,
                                 glm::clamp(from, glm::dvec3(patch->lowest), glm::dvec3(patch->highest)));
        };
        for (std::size_t k = 1; k < visible.size(); ++k)
            EXPECT_LE(distance(visible[k - 1]), distance(visible[k]) + 0.01);
    }
}

}  // namespace
}  // namespace render::test
