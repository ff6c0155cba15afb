#include "game/controls/probe.h"

#include <cmath>

#include <gtest/gtest.h>

#include "sim/engine.h"
#include "tests/support/allocations.h"
#include "tests/support/worlds.h"

namespace game::test {
namespace {

constexpr double kDegree = 3.14159265358979323846 / 180;

// 20 squares of 5 m that rise by `east` and `north` metres per metre.
sim::State hillside(double east, double north) {
    support::Ground ground({21, 23, 5.f});
    ground.set(ground.bedrock, [=](double x, double y) { return east * x + north * y; });
    ground.set(ground.depth, [](double, double) { return 1.5; });
    return sim::make_state(ground.world(), {});
}

terrains::Georeference nowhere() {
    return {};
}

TEST(Probe, reads_the_slope_and_aspect_of_a_plane) {
    for (const double steepness : {3.0, 30.0, 60.0})
        for (int bearing = 0; bearing < 360; bearing += 15) {
            const double tangent = std::tan(steepness * kDegree);
            const auto state =
                hillside(-tangent * std::sin(bearing * kDegree), -tangent * std::cos(bearing * kDegree));
            const auto reading = Probe(nowhere()).read(sim::view(state), {33.3, 71.9}).value();
            EXPECT_NEAR(reading.slope_deg, steepness, 1e-4);
            ASSERT_TRUE(reading.aspect_deg);
            EXPECT_GE(*reading.aspect_deg, 0);
            EXPECT_LT(*reading.aspect_deg, 360);
            EXPECT_NEAR(std::remainder(*reading.aspect_deg - bearing, 360), 0, 1e-3) << bearing;
        }
}

TEST(Probe, names_no_aspect_where_it_is_level) {
    const auto state = hillside(0, 0);
    const auto reading = Probe(nowhere()).read(sim::view(state), {50, 50}).value();
    EXPECT_EQ(reading.slope_deg, 0);
    EXPECT_FALSE(reading.aspect_deg);
}

// One square worked out by hand: corners 10, 14, 12, 20 m (south-west, south-east, north-west, north-east).
TEST(Probe, is_bilinear_between_four_vertices) {
    auto state = hillside(0, 0);
    state.datum = 1000;
    state.depth.fill(0);
    state.bedrock(4, 6) = 10, state.bedrock(5, 6) = 14, state.bedrock(4, 7) = 12, state.bedrock(5, 7) = 18;
    state.rolling(5, 7) = 2;
    state.velocity_x(5, 7) = 3, state.velocity_y(5, 7) = -4;
    const auto reading = Probe(nowhere()).read(sim::view(state), {4.25 * 5, 6.5 * 5}).value();
    EXPECT_DOUBLE_EQ(reading.at.x, 21.25);
    EXPECT_DOUBLE_EQ(reading.at.y, 32.5);
    EXPECT_DOUBLE_EQ(reading.at.z, 1000 + (11 + 14) / 2.0);  // 10 + ¼ · 4 and 12 + ¼ · 8
    EXPECT_DOUBLE_EQ(reading.rolling, 2 * 0.25 * 0.5);
    EXPECT_DOUBLE_EQ(reading.standing, 0);
    EXPECT_DOUBLE_EQ(reading.speed_plan, 5 * 0.25 * 0.5);
    EXPECT_NEAR(reading.slope_deg, std::atan(std::hypot((4 + 8) / 2.0, 2 + 0.25 * 4) / 5) / kDegree, 1e-9);
}

TEST(Probe, counts_heights_from_the_lowest_ground_of_a_place_that_is_nowhere_and_below_zero) {
    const auto height_of = [](const sim::State& state, const terrains::Georeference& place) {
        const sim::View world = sim::view(state);
        return Probe(place, {}, zero_of_heights(world, place)).read(world, {0, 50}).value().height;
    };
    auto state = hillside(-0.5, 0);  // down to −50 m, with 1.5 m of snow
    EXPECT_DOUBLE_EQ(height_of(state, nowhere()), 51.5);
    EXPECT_DOUBLE_EQ(height_of(state, terrains::Georeference::unnamed(0, 0)), 1.5);
    state.datum = 1000;
    EXPECT_DOUBLE_EQ(height_of(state, nowhere()), 1001.5);
}

TEST(Probe, reads_the_things_that_stand_there) {
    auto state = hillside(0, 0);
    const auto command = [](sim::CommandKind kind, double x, double y) {
        sim::Command c;
        c.kind = kind;
        c.x = x, c.y = y;
        return c;
    };
    auto house = command(sim::CommandKind::kHouse, 50, 50);
    house.length = 12, house.width = 6, house.height = 5, house.strength = 5, house.turn = 90;
    auto road = command(sim::CommandKind::kRoad, 10, 90);
    road.to_x = 60, road.to_y = 90, road.width = 8;
    auto forest = command(sim::CommandKind::kPlant, 80, 20);
    forest.radius = 12, forest.stems = 400, forest.diameter = 0.3, forest.height = 22;
    auto dam = command(sim::CommandKind::kSculpt, 20, 20);
    dam.radius = 8, dam.rise = 1.5;
    const sim::Engine engine(state, {});
    sim::apply_commands(state, std::vector<sim::Command>{house, road, forest, dam});
    state.things->list[0].load = 3000;

    Probe probe(nowhere());
    const auto at = [&](double x, double y) { return probe.read(sim::view(state), {x, y}).value(); };
    ASSERT_TRUE(at(55.9, 52.9).thing);  // its front faces east
    EXPECT_EQ(at(55.9, 52.9).thing->kind, sim::ThingKind::kHouse);
    EXPECT_TRUE(at(50, 50).thing->damaged());
    EXPECT_FALSE(at(57.4, 50).thing);  // over a quarter of a cell away
    ASSERT_TRUE(at(30, 93.9).thing);
    EXPECT_EQ(at(30, 93.9).thing->kind, sim::ThingKind::kRoad);
    EXPECT_EQ(at(80, 20).forest.standing, 400);
    EXPECT_EQ(at(80, 20).forest.height_m, 22);
    EXPECT_EQ(at(50, 50).forest.standing, 0);
    EXPECT_NEAR(at(20, 20).earth, 1.5, 1e-4);
    EXPECT_FALSE(at(20, 20).thing);
}

TEST(Probe, names_no_speed_where_nothing_rolls) {
    auto state = hillside(0, 0);
    state.velocity_x(4, 6) = 3;
    const Reading thin = Probe(nowhere()).read(sim::view(state), {20, 30}).value();
    EXPECT_EQ(thin.speed_plan, 0);
    EXPECT_EQ(thin.speed_slope, 0);
    state.rolling(4, 6) = 1;
    const Reading thick = Probe(nowhere()).read(sim::view(state), {20, 30}).value();
    EXPECT_EQ(thick.speed_plan, 3);
    EXPECT_EQ(thick.speed_slope, 3) << "the ground is level";
}

// Down and across a plane of 45°, in the middle, on the border and beside no data.
TEST(Probe, reads_the_speed_along_the_slope_of_the_ground) {
    auto state = hillside(1, 0);
    state.site(10, 11) = sim::Site::kDrain, state.bedrock(10, 11) = -500;
    state.rolling.fill(1);
    Probe probe(nowhere());
    for (const glm::dvec2 at :
         {glm::dvec2(21, 32), glm::dvec2(0, 30), glm::dvec2(100, 110), glm::dvec2(43, 56)}) {
        state.velocity_x.fill(-3), state.velocity_y.fill(0);
        const Reading down = probe.read(sim::view(state), at).value();
        EXPECT_EQ(down.speed_plan, 3);
        EXPECT_NEAR(down.speed_slope, 3 * std::sqrt(2.), 1e-6);
        state.velocity_x.fill(0), state.velocity_y.fill(3);
        const Reading across = probe.read(sim::view(state), at).value();
        EXPECT_EQ(across.speed_plan, 3);
        EXPECT_NEAR(across.speed_slope, 3, 1e-6);
    }
}

TEST(Probe, reads_the_pressure_of_the_mixture_under_it) {
    support::Ground ground = support::plane(20, 5, 1, 2);
    ground.lower = sim::Params{};
    for (float& depth : ground.lower_depth) depth = 1;
    ground.rolling.assign(ground.grid.size(), 1.f);
    sim::State state = sim::make_state(ground.world(), {});
    state.mixture->rolling.fill(0.25f);
    state.velocity_y.fill(10);
    EXPECT_FALSE(Probe(nowhere()).read(sim::view(state), {50, 50})->pressure);
    EXPECT_NEAR(*Probe(nowhere(), Densities{200, 1800}).read(sim::view(state), {50, 50})->pressure,
                600 * 200 / 1000., 1e-3);  // kg/m³ and m²/s²
}

TEST(Probe, reads_up_to_the_border_and_not_beyond) {
    const auto state = hillside(0.5, 0);
    Probe probe(nowhere());
    for (const glm::dvec2 on : {glm::dvec2(0, 0), glm::dvec2(100, 110), glm::dvec2(-1e-9, 110 + 1e-9)}) {
        ASSERT_TRUE(probe.read(sim::view(state), on));
        EXPECT_NEAR(probe.read(sim::view(state), on)->at.z, 1.5 + 0.5 * on.x, 1e-5);
    }
    for (const glm::dvec2 off : {glm::dvec2(-0.01, 50), glm::dvec2(100.01, 50), glm::dvec2(50, -0.01),
                                 glm::dvec2(50, 110.01), glm::dvec2(std::nan(""), 50), glm::dvec2(1e300, 50)})
        EXPECT_FALSE(probe.read(sim::view(state), off));
}

TEST(Probe, reads_nothing_where_a_vertex_has_no_data) {
    auto state = hillside(0, 0);
    state.site(10, 10) = sim::Site::kDrain;
    Probe probe(nowhere());
    for (const double x : {48.0, 52.0})
        for (const double y : {48.0, 52.0}) EXPECT_FALSE(probe.read(sim::view(state), {x, y}));
    EXPECT_TRUE(probe.read(sim::view(state), {56, 50}));
    EXPECT_TRUE(probe.read(sim::view(state), {44, 50}));
}

TEST(Probe, says_where_it_is_on_earth) {
    const auto state = hillside(0, 0);
    const auto georeference = terrains::Georeference::local({47.3, 11.43}, -50, -60);
    Probe probe(georeference);
    for (const glm::dvec2 at : {glm::dvec2(50, 60), glm::dvec2(51, 60), glm::dvec2(50, 60)})
        EXPECT_EQ(probe.read(sim::view(state), at)->where.data(), georeference.describe({at.x, at.y}));
    EXPECT_STREQ(Probe(nowhere()).read(sim::view(state), {50, 60})->where.data(), "");
}

TEST(Probe, tells_how_much_of_what_rolls_or_else_lies_is_the_lower_material) {
    support::Ground ground = support::plane(20, 5, 0.6, 2);
    Probe probe(nowhere());
    const sim::State single = sim::make_state(ground.world(), {});
    EXPECT_FALSE(probe.read(sim::view(single), {50, 50})->lower_share);

    ground.lower = sim::Params{};
    for (float& depth : ground.lower_depth) depth = 1.99f;
    ground.rolling[ground.at(4, 4)] = 1;
    sim::State state = sim::make_state(ground.world(), {});
    state.mixture->rolling(4, 4) = 0.25f;
    EXPECT_EQ(probe.read(sim::view(state), {20, 20})->lower_share, 0.25);
    EXPECT_NEAR(*probe.read(sim::view(state), {50, 50})->lower_share, 0.8, 1e-3);  // of the uppermost 5 cm
}

TEST(Probe, allocates_nothing) {
    const auto state = hillside(0.3, 0.1);
    const auto local = terrains::Georeference::local({47.3, 11.43}, -50, -60);
    for (const auto& georeference :
         {nowhere(), local, terrains::Georeference::projected(local.wkt(), -50, -60)}) {
        Probe probe(georeference);
        probe.read(sim::view(state), {1, 1});
        const std::int64_t before = support::allocations();
        for (int i = 0; i < 100; ++i) probe.read(sim::view(state), {1.1 * i, 0.7 * i});
        EXPECT_EQ(support::allocations() - before, 0);
    }
}

}  // namespace
}  // namespace game::test
