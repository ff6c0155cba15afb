#include "sim/world/mixture.h"

#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "sim/world/snapshot.h"
#include "sim/world/state_hash.h"
#include "tests/support/worlds.h"

// Two materials in one world: nothing is lost, each moves by its own parameters, and a mixture by blended
// ones.

namespace {

using support::Ground;
using support::Play;

using support::kPhysics;
using support::Physics;

sim::Params upper_of(const Physics& physics) {
    return support::lively(physics.model, physics.scheme);
}
// Heavier, slower, stable on steeper ground.
sim::Params lower_of(const Physics& physics) {
    sim::Params params = upper_of(physics);
    params.exchange_rate = 0.8f;
    params.rolling_speed = 2;
    params.max_speed = 6;
    params.speed_per_slope = 8;
    params.stop_slope = 0.55f;
    params.friction = 0.45f;
    params.friction_thin = 0.85f;
    params.drag = 400;
    params.start_slope = 0.8f;
    params.erosion_slope = params.loose_slope = 0.6f;
    return params;
}

// A rough valley; the lower half of its erodible layer is the other material.
Ground half_and_half(const Physics& physics, unsigned seed) {
    Ground ground = support::rough(29, 4, seed);
    ground.lower = lower_of(physics);
    for (std::size_t i = 0; i < ground.depth.size(); ++i) ground.lower_depth[i] = 0.5f * ground.depth[i];
    return ground;
}

void expect_sound(const sim::State& s, const std::string& what) {
    const sim::Mixture& m = *s.mixture;
    ASSERT_EQ(s.ledger.mass_error(), 0) << what;
    ASSERT_EQ(m.ledger.mass_error(), 0) << what;
    const auto whole = [](float metres) { return std::fmod(metres, sim::kQuantum) == 0; };
    for (int y = 0; y < s.grid.ny; ++y)
        for (int x = 0; x < s.grid.nx; ++x) {
            const float above = s.depth(x, y) - m.untouched(x, y);
            ASSERT_TRUE(m.rolling(x, y) >= 0 && m.rolling(x, y) <= s.rolling(x, y)) << what;
            ASSERT_TRUE(m.untouched(x, y) >= 0 && above >= 0) << what;
            ASSERT_TRUE(m.settled(x, y) >= 0 && m.settled(x, y) <= above) << what;
            ASSERT_TRUE(whole(m.rolling(x, y)) && whole(m.settled(x, y)) && whole(m.untouched(x, y))) << what;
        }
}

sim::Command command_of(std::mt19937& random, const sim::Grid& grid) {
    const auto number = [&](double least, double most) {
        return least + (most - least) * static_cast<double>(random()) / 4294967296.0;
    };
    constexpr sim::CommandKind kKinds[] = {sim::CommandKind::kPour, sim::CommandKind::kDig,
                                           sim::CommandKind::kBlast, sim::CommandKind::kSettle};
    sim::Command c;
    c.kind = kKinds[random() % 4];
    c.x = number(0, grid.nx * static_cast<double>(grid.dx));
    c.y = number(0, grid.ny * static_cast<double>(grid.dx));
    c.radius = number(0, 30);
    c.rate = c.kind == sim::CommandKind::kPour ? number(0, 500) : number(0, 2);
    c.duration = number(0, 0.5);
    c.depth = number(0, 2);
    c.layer = random() % 2 ? sim::Layer::kRolling : sim::Layer::kStanding;
    c.of = random() % 2 ? sim::Part::kUpper : sim::Part::kLower;
    return support::of_its_kind(c);
}

TEST(Mixture, conserves_mass_and_stays_within_its_layers_under_any_commands) {
    for (const Physics& physics : kPhysics)
        for (const auto border : {sim::Border::kWall, sim::Border::kOpen, sim::Border::kSink}) {
            Ground ground = half_and_half(physics, 7);
            ground.has_data[ground.at(11, 14)] = ground.has_data[ground.at(12, 14)] = 0;
            sim::Params params = upper_of(physics);
            params.borders.fill(border);
            Play play(ground, params, {.threads = 2});
            std::mt19937 random(3);
            for (int tick = 0; tick < 150; ++tick) {
                const sim::Command command = command_of(random, ground.grid);
                play.ticks(1, {&command, tick % 3 == 0 ? 1u : 0u});
                expect_sound(play.state, physics.name() + ", tick " + std::to_string(tick));
                if (HasFatalFailure()) return;
            }
            EXPECT_GT(play.state.mixture->ledger.poured, 0);
            EXPECT_GT(play.state.mixture->ledger.dug, 0);
            if (border != sim::Border::kWall) {
                EXPECT_GT(play.state.mixture->ledger.out, 0) << physics.name();
            }
        }
}

// Compares the layers of a mixture of one material with those of a plain world.
void expect_layers(const sim::State& mixed, const sim::State& plain, const std::string& what) {
    ASSERT_TRUE(support::same_bits(mixed.depth, plain.depth)) << what;
    ASSERT_TRUE(support::same_bits(mixed.rolling, plain.rolling)) << what;
    ASSERT_TRUE(support::same_bits(mixed.velocity_x, plain.velocity_x)) << what;
    ASSERT_TRUE(support::same_bits(mixed.velocity_y, plain.velocity_y)) << what;
}

TEST(Mixture, of_one_material_is_bit_identical_to_a_plain_world) {
    for (const Physics& physics : kPhysics) {
        Ground ground = half_and_half(physics, 5);
        // initial rolling material is the upper one
        std::fill(ground.rolling.begin(), ground.rolling.end(), 0.f);
        Ground single = ground;
        single.lower.reset();
        for (const bool lower : {false, true}) {
            sim::Params world = upper_of(physics);
            world.max_speed = lower_of(physics).max_speed;  // to get the same number of sub-steps
            world.rolling_speed = lower_of(physics).rolling_speed;
            for (std::size_t i = 0; i < ground.depth.size(); ++i)
                ground.lower_depth[i] = lower ? ground.depth[i] : 0;
            Play mixed(ground, world), alone(single, lower ? lower_of(physics) : world);
            sim::Command blast;  // because natural ground holds
            blast.kind = sim::CommandKind::kBlast, blast.x = 60, blast.y = 40, blast.radius = 30,
            blast.depth = 1;
            for (int tick = 0; tick < 60; ++tick) {
                for (Play* play : {&mixed, &alone}) play->ticks(1, {&blast, tick == 0 ? 1u : 0u});
                expect_layers(mixed.state, alone.state, physics.name() + (lower ? ", lower" : ", upper"));
                if (HasFatalFailure()) return;
            }
            EXPECT_GT(alone.state.ledger.rolling, 0) << physics.name();
        }
    }
}

TEST(Mixture, of_two_materials_with_equal_parameters_moves_as_one) {
    for (const Physics& physics : kPhysics) {
        Ground ground = half_and_half(physics, 9), single = ground;
        ground.lower = upper_of(physics);
        single.lower.reset();
        Play mixed(ground, upper_of(physics)), alone(single, upper_of(physics));
        for (int tick = 0; tick < 60; ++tick) {
            mixed.ticks(1), alone.ticks(1);
            expect_layers(mixed.state, alone.state, physics.name());
            if (HasFatalFailure()) return;
        }
        if (physics.model == sim::Model::kVoellmy) continue;  // it takes nothing along
        EXPECT_GT(mixed.state.mixture->ledger.rolling, 0) << physics.name();
    }
}

TEST(Mixture, is_bit_identical_with_any_number_of_threads_and_after_a_rewind) {
    for (const Physics& physics : kPhysics) {
        const Ground ground = half_and_half(physics, 11);
        Play one(ground, upper_of(physics));
        one.ticks(20);
        const sim::Snapshot moment = sim::take_snapshot(one.state);
        one.ticks(20);
        const std::uint64_t hash = sim::state_hash(one.state);
        for (const int threads : {2, 3, 5, 8}) {
            Play other(ground, upper_of(physics), {.threads = threads});
            other.ticks(40);
            EXPECT_EQ(sim::state_hash(other.state), hash) << physics.name() << ", threads " << threads;
        }
        sim::restore(moment, one.state);
        one.ticks(20);
        EXPECT_EQ(sim::state_hash(one.state), hash) << physics.name();
    }
}

TEST(Mixture, is_part_of_the_hash) {
    const Ground ground = half_and_half(kPhysics[3], 13);
    Play play(ground, upper_of(kPhysics[3]));
    play.ticks(30);
    const std::uint64_t hash = sim::state_hash(play.state);
    for (auto* field :
         {&play.state.mixture->rolling, &play.state.mixture->settled, &play.state.mixture->untouched}) {
        float& value = (*field)(7, 9);
        value += sim::kQuantum;
        EXPECT_NE(sim::state_hash(play.state), hash);
        value -= sim::kQuantum;
    }
    EXPECT_EQ(sim::state_hash(play.state), hash);
}

// A blast releases the upper material while there is any, then the lower one.
TEST(Mixture, releases_the_upper_material_first) {
    Ground ground = support::plane(8, 2, 0, 3);
    ground.lower = lower_of(kPhysics[3]);
    for (float& depth : ground.lower_depth) depth = 2;
    Play play(ground, upper_of(kPhysics[3]));
    sim::State& s = play.state;
    EXPECT_EQ(sim::share_at_surface(sim::view(s), 4, 4), 0);

    sim::start_mixture(s, 4, 4, 1);
    s.depth(4, 4) -= 1, s.rolling(4, 4) += 1;
    EXPECT_EQ(sim::share_in_rolling(sim::view(s), 4, 4), 0);
    EXPECT_EQ(sim::share_at_surface(sim::view(s), 4, 4), 1);

    sim::start_mixture(s, 4, 4, 1);
    s.depth(4, 4) -= 1, s.rolling(4, 4) += 1;
    EXPECT_EQ(sim::share_in_rolling(sim::view(s), 4, 4), 0.5f);

    // Material that comes to rest keeps its mixture and lies above the untouched part.
    sim::stop_mixture(s, 4, 4, 0.5f);
    s.depth(4, 4) += 0.5f, s.rolling(4, 4) -= 0.5f;
    EXPECT_EQ(sim::share_at_surface(sim::view(s), 4, 4), 0.5f);
    EXPECT_EQ(s.mixture->settled(4, 4), 0.25f);
    EXPECT_EQ(s.mixture->untouched(4, 4), 1);
    EXPECT_EQ(sim::share_in_rolling(sim::view(s), 4, 4), 0.5f);
}

// A film that moves less than a quantum of the lower material per sub-step still moves the right amount over
// time.
TEST(Mixture, is_advected_without_bias) {
    Ground ground = support::plane(40, 2, 0.75, 0);
    ground.lower = upper_of(kPhysics[1]);
    Play play(ground, upper_of(kPhysics[1]));
    for (const auto part : {sim::Part::kUpper, sim::Part::kLower}) {
        sim::Command pour = support::pour_at(40, 20, 10, part == sim::Part::kLower ? 1 : 3, 1000);
        pour.of = part;
        play.ticks(1, {&pour, 1});
    }
    play.ticks(1200);
    const sim::Mixture& m = *play.state.mixture;
    const double share = static_cast<double>(m.ledger.out) / static_cast<double>(play.state.ledger.out);
    EXPECT_NEAR(share, 0.25, 0.002);
    EXPECT_NEAR(static_cast<double>(sim::share_in_rolling(sim::view(play.state), 20, 30)), 0.25, 0.005);
}

// Snow over soil on a slope that holds the soil: the slide entrains the snow and leaves the soil bare.
TEST(Mixture, erodes_each_material_by_its_own_threshold) {
    sim::Params snow = upper_of(kPhysics[3]), soil = snow;
    snow.friction = 0.3f, snow.erosion_slope = 0.5f, snow.start_slope = 0.9f;
    soil.friction = 0.5f, soil.erosion_slope = 2, soil.start_slope = 3;
    Ground ground = support::plane(60, 2, 0.75, 2);
    ground.lower = soil;
    for (float& depth : ground.lower_depth) depth = 1;
    Play play(ground, snow);
    sim::Command blast;
    blast.kind = sim::CommandKind::kBlast, blast.x = 60, blast.y = 20, blast.radius = 8, blast.depth = 1;
    play.ticks(1, {&blast, 1});
    play.ticks(1800);
    int bared = 0;
    float soil_taken = 0;
    for (int y = 0; y < play.state.grid.ny; ++y)
        for (int x = 0; x < play.state.grid.nx; ++x) {
            bared += play.state.depth(x, y) < 1.3f;
            soil_taken = std::max(soil_taken, 1 - play.state.mixture->untouched(x, y));
        }
    EXPECT_GT(bared, 200);
    EXPECT_LT(soil_taken, 0.1f);  // except soil that erodes as part of a blend with snow
}

}  // namespace
