// The first seconds of the avalanche path that COULOIR_DEM_DIR names, beside free fall without friction:
// docs/results/real-paths.md.
#include <algorithm>
#include <cmath>
#include <string>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "game/scene/scene.h"
#include "game/scene/surface.h"
#include "sim/engine.h"
#include "sim/step.h"
#include "tests/support/places.h"

namespace game::test {
namespace {

class RealStart : public testing::TestWithParam<sim::Model> {};

// What the first seconds are compared with.
struct Release {
    double acceleration;  // m/s² in plan, of the centre of mass on this ground without friction
    double layer;         // m, the greatest thickness normal to the ground
};

// g sinθ cosθ toward the fall line, its mean by mass.
Release release_of(const sim::View& world) {
    glm::dvec2 sum{0};
    double mass = 0, layer = 0;
    for (int y = 1; y + 1 < world.grid.ny; ++y)
        for (int x = 1; x + 1 < world.grid.nx; ++x) {
            const double r = world.rolling(x, y);
            if (r <= 0) continue;
            const glm::dvec2 slope = ground_slope(world, x, y);
            const double squared = slope.x * slope.x + slope.y * slope.y;
            sum.x -= r * 9.81 * slope.x / (1 + squared), sum.y -= r * 9.81 * slope.y / (1 + squared);
            mass += r, layer = std::max(layer, r / std::sqrt(1 + squared));
        }
    return {std::hypot(sum.x, sum.y) / mass, layer};
}

TEST_P(RealStart, never_outruns_free_fall) {
    if (!support::dem_dir()) GTEST_SKIP() << "COULOIR_DEM_DIR is not set";
    const auto inputs = *support::dem_dir() / "alr";
    Overrides overrides;
    overrides.squares = 936;
    overrides.model = GetParam();
    const auto scene = scene_of_terrain(inputs / "alr_utm32n.tif",
                                        ReleaseFile{inputs / "release.geojson", std::nullopt}, overrides);
    ASSERT_TRUE(scene) << scene.error().sentence;
    sim::State state = sim::make_state(initial_state_of(scene->scenario), scene->scenario.params);
    sim::Engine engine(state);
    const Release release = release_of(sim::view(state));
    const double ahead = 2 * std::sqrt(9.81 * release.layer);  // of the front of a dam break
    fmt::print("{}: {:.2f} m/s2 in plan, layer {:.2f} m\n", sim::to_string(GetParam()), release.acceleration,
               release.layer);
    for (int tick = 1; tick <= 300; ++tick) {
        sim::step(state, {}, engine);
        if (tick % 60 != 0 || tick == 240) continue;
        glm::dvec2 momentum{0};
        double mass = 0, fastest = 0;
        for (int y = 0; y < state.grid.ny; ++y)
            for (int x = 0; x < state.grid.nx; ++x) {
                const double r = state.rolling(x, y), u = state.velocity_x(x, y), v = state.velocity_y(x, y);
                if (r <= 0) continue;
                mass += r, momentum.x += r * u, momentum.y += r * v;
                fastest = std::max(fastest, std::hypot(u, v));
            }
        const double centre = std::hypot(momentum.x, momentum.y) / mass,
                     free_fall = release.acceleration * tick / 60;
        fmt::print(
            "{:>3} s: centre of mass {:5.2f} m/s, {:.2f} of free fall {:5.2f}; fastest {:5.2f}, bound "
            "{:5.2f}\n",
            tick / 60, centre, centre / free_fall, free_fall, fastest, free_fall + ahead);
        EXPECT_LE(centre, free_fall);
        EXPECT_LE(fastest, free_fall + ahead);
    }
}

INSTANTIATE_TEST_SUITE_P(Model, RealStart, testing::Values(sim::Model::kVoellmy, sim::Model::kBcreInertial),
                         [](const auto& info) {
                             return std::string(info.param == sim::Model::kVoellmy ? "voellmy" : "inertial");
                         });

}  // namespace
}  // namespace game::test
