#include "render/mountain/pick.h"

#include <algorithm>
#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include <glm/geometric.hpp>
#include <glm/vec4.hpp>

#include "assets/shaders/slots.glsl"
#include "render/mountain/ground_mesh.h"
#include "render/mountain/overview.h"
#include "tests/render/world.h"
#include "tests/support/worlds.h"

namespace render {
namespace {

// Rough ground with a few holes and a datum, as a view.
test::World rough_world(unsigned seed) {
    const support::Ground ground = support::rough(24, 3, seed);
    test::World world = test::make_world(24, 3, [](double, double) { return 0; });
    world.grid = ground.grid;
    world.bedrock = world.depth = world.rolling = sim::Field<float>(world.grid);
    world.site = sim::Field<sim::Site>(world.grid);
    world.datum = 1403;
    std::mt19937 random(seed);
    for (int y = 0; y < world.grid.ny; ++y) {
        for (int x = 0; x < world.grid.nx; ++x) {
            world.bedrock(x, y) = ground.bedrock[ground.at(x, y)];
            world.depth(x, y) = 4 * ground.depth[ground.at(x, y)];
            world.rolling(x, y) = 9 * ground.rolling[ground.at(x, y)];
            if (random() % 23 == 0) world.site(x, y) = sim::Site::kDrain;
        }
    }
    return world;
}

glm::dvec3 vertex(const test::World& world, std::uint32_t index) {
    const int x = static_cast<int>(index & INDEX_X_MASK), y = static_cast<int>(index >> INDEX_Y_SHIFT);
    return {x * static_cast<double>(world.grid.dx), y * static_cast<double>(world.grid.dx),
            world.datum + world.bedrock(x, y) + world.depth(x, y) + world.rolling(x, y)};
}

// Intersects every triangle of the mesh in turn (Möller and Trumbore 1997), front faces only.
std::optional<glm::dvec3> pick_slowly(const test::World& world, const GroundMesh& mesh, const Ray& ray) {
    double nearest = 1e30;
    for (std::size_t i = 0; i < mesh.surface.size(); i += 3) {
        const glm::dvec3 a = vertex(world, mesh.surface[i]);
        const glm::dvec3 ab = vertex(world, mesh.surface[i + 1]) - a,
                         ac = vertex(world, mesh.surface[i + 2]) - a;
        const glm::dvec3 p = glm::cross(ray.along, ac), s = ray.from - a;
        const double facing = glm::dot(ab, p);
        if (facing <= 0) continue;
        const glm::dvec3 q = glm::cross(s, ab);
        const double u = glm::dot(s, p) / facing, v = glm::dot(ray.along, q) / facing;
        const double t = glm::dot(ac, q) / facing;
        if (u >= 0 && v >= 0 && u + v <= 1 && t >= 0) nearest = std::min(nearest, t);
    }
    if (nearest == 1e30) return std::nullopt;
    return ray.from + nearest * ray.along;
}

struct Tally {
    int hits = 0, misses = 0;
};

// Compares with the brute-force search for rays that `next` makes.
template <class Next>
Tally compare(unsigned seed, int rays, Next next) {
    const test::World world = rough_world(seed);
    const GroundMesh mesh = ground_mesh(world.grid, world.site);
    std::mt19937 random(seed + 100);
    std::uniform_real_distribution<double> share(0, 1);
    Tally tally;
    for (int i = 0; i < rays; ++i) {
        const Ray ray = next(world, [&] { return share(random); });
        const auto fast = pick(world.view(), ray), slow = pick_slowly(world, mesh, ray);
        EXPECT_EQ(fast.has_value(), slow.has_value()) << "world " << seed << ", ray " << i;
        if (fast && slow) {
            EXPECT_LT(glm::distance(*fast, *slow), 1e-6) << "world " << seed << ", ray " << i;
        }
        ++(fast ? tally.hits : tally.misses);
    }
    return tally;
}

template <class Share>
glm::dvec3 direction(Share share) {
    glm::dvec3 along(0);
    do {
        along = {2 * share() - 1, 2 * share() - 1, 2 * share() - 1};
    } while (glm::length(along) > 1 || glm::length(along) < 0.1);
    return glm::normalize(along);
}

TEST(Pick, equals_a_search_of_all_triangles_from_all_around) {
    for (unsigned seed = 1; seed <= 4; ++seed) {
        const Tally tally = compare(seed, 1500, [](const test::World& world, auto share) {
            const glm::dvec3 middle(world.side() / 2, world.side() / 2, world.datum - 20);
            const glm::dvec3 from = middle + 150.0 * direction(share);
            const glm::dvec3 aim = middle + 60.0 * direction(share);
            return Ray{from, glm::normalize(aim - from)};
        });
        EXPECT_GT(tally.hits, 100) << seed;
        EXPECT_GT(tally.misses, 200) << seed;
    }
}

TEST(Pick, equals_a_search_of_all_triangles_from_between_hills) {
    for (unsigned seed = 5; seed <= 8; ++seed) {
        const Tally tally = compare(seed, 1500, [](const test::World& world, auto share) {
            const double x = share() * world.side(), y = share() * world.side();
            return Ray{{x, y, world.datum - 0.6 * y + 8 * share() - 2}, direction(share)};
        });
        EXPECT_GT(tally.hits, 200) << seed;
        EXPECT_GT(tally.misses, 200) << seed;
    }
}

TEST(Pick, equals_a_search_of_all_triangles_along_rows_columns_and_verticals) {
    for (unsigned seed = 9; seed <= 11; ++seed) {
        const Tally tally = compare(seed, 900, [](const test::World& world, auto share) {
            const glm::dvec3 from(share() * world.side(), share() * world.side(),
                                  world.datum + 6 - 45 * share());
            const double kind = share(), sign = share() < 0.5 ? -1 : 1;
            if (kind < 0.3) return Ray{from, {sign, 0, 0}};
            if (kind < 0.6) return Ray{from, {0, sign, 0}};
            return Ray{from + glm::dvec3(0, 0, 60), {0, 0, -1}};
        });
        EXPECT_GT(tally.hits, 100) << seed;
        EXPECT_GT(tally.misses, 100) << seed;
    }
}

TEST(Pick, returns_the_vertex_projected_to_the_image_point) {
    test::World world = test::make_world(
        40, 5, [](double x, double y) { return 0.5 * y + 6 * std::sin(x / 25) * std::cos(y / 30); });
    world.datum = 800;
    const Camera camera = overview(world.view());
    const double aspect = 1.6;
    int seen = 0;
    for (int y = 0; y <= 40; ++y) {
        for (int x = 0; x <= 40; ++x) {
            const glm::dvec3 at = vertex(world, surface_index(x, y));
            const glm::dvec4 clip =
                projection_matrix(camera, aspect) * view_matrix(camera) * glm::dvec4(at, 1);
            const auto found = pick(world.view(), ray_through(camera, aspect, glm::dvec2(clip) / clip.w));
            const bool on_rim = x == 0 || y == 0 || x == 40 || y == 40;
            if (!found && on_rim) continue;  // rounding may move a ray beyond the edge of the world
            ASSERT_TRUE(found) << x << ", " << y;
            const bool hidden = glm::distance(*found, eye(camera)) < glm::distance(at, eye(camera)) - 0.01;
            if (hidden) continue;
            EXPECT_LT(glm::distance(*found, at), 1e-6) << x << ", " << y;
            ++seen;
        }
    }
    EXPECT_GT(seen, 1000);
}

TEST(Pick, meets_the_surface_with_both_layers_on_it) {
    test::World world = test::make_world(4, 2, [](double, double) { return 1; });
    world.datum = 100;
    world.depth.fill(2);
    world.rolling.fill(0.5f);
    const auto at = pick(world.view(), {{3.3, 4.1, 500}, {0, 0, -1}});
    ASSERT_TRUE(at);
    EXPECT_NEAR(at->z, 103.5, 1e-9);
    EXPECT_NEAR(at->x, 3.3, 1e-9);
    EXPECT_NEAR(at->y, 4.1, 1e-9);
}

TEST(Pick, cuts_a_square_from_lower_left_to_upper_right) {
    test::World world = test::make_world(2, 1, [](double, double) { return 0; });
    world.bedrock(1, 1) = 1;
    const auto height = [&](double x, double y) { return pick(world.view(), {{x, y, 9}, {0, 0, -1}})->z; };
    EXPECT_NEAR(height(0.75, 0.75), 0.75, 1e-9);  // on the cut
    EXPECT_NEAR(height(0.75, 0.25), 0.25, 1e-9);
    EXPECT_NEAR(height(0.25, 0.75), 0.25, 1e-9);
    EXPECT_NEAR(height(1.5, 0.5), 0, 1e-9);  // in the square beside it the diagonal runs outside the peak
}

TEST(Pick, is_empty_beside_the_world_below_it_and_at_no_data) {
    test::World world = test::make_world(6, 1, [](double, double) { return 0; });
    const auto misses = [&](const Ray& ray) { return !pick(world.view(), ray).has_value(); };
    EXPECT_TRUE(misses({{-0.1, 3, 5}, {0, 0, -1}}));
    EXPECT_TRUE(misses({{3, 6.1, 5}, {0, 0, -1}}));
    EXPECT_TRUE(misses({{3, 3, 5}, {0, 0, 1}}));
    EXPECT_TRUE(misses({{3, 3, -5}, {0, 0, 1}}));
    EXPECT_TRUE(misses({{-5, 3, 1}, {1, 0, 0}}));
    EXPECT_FALSE(misses({{3, 3, 5}, {0, 0, -1}}));
    world.site(3, 3) = sim::Site::kDrain;
    EXPECT_TRUE(misses({{3.2, 3.1, 5}, {0, 0, -1}}));
    EXPECT_FALSE(misses({{3.9, 2.05, 5}, {0, 0, -1}}));  // the neighbouring square at this corner is whole
}

TEST(Pick, finds_a_face_steeper_than_an_upward_view) {
    const test::World cliff =
        test::make_world(20, 1, [](double, double y) { return y < 10 ? 0 : 3 * (y - 10); });
    const double s = std::sqrt(0.5);
    const auto at = pick(cliff.view(), {{10.3, 2, 1}, {0, s, s}});  // z = 1 + (y − 2) meets 3 (y − 10)
    ASSERT_TRUE(at);
    EXPECT_NEAR(at->y, 14.5, 1e-9);
    EXPECT_NEAR(at->z, 13.5, 1e-9);
    EXPECT_FALSE(pick(cliff.view(), {{10.3, 12, 30}, {0, s, s}}));
}

TEST(Pick, ignores_the_ground_from_below) {
    const test::World slope = test::make_world(20, 1, [](double, double y) { return 2 * y; });
    EXPECT_FALSE(pick(slope.view(), {{10.3, 18, 5}, {0, -1, 0}}));  // comes out at y = 2.5
    EXPECT_TRUE(pick(slope.view(), {{10.3, 0.5, 5}, {0, 1, 0}}));
}

}  // namespace
}  // namespace render
