#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "sim/simd/instruction_set.h"
#include "sim/weather/sky.h"
#include "sim/world/quanta.h"
#include "sim/world/snapshot.h"
#include "sim/world/state_hash.h"
#include "tests/support/worlds.h"

// Weather hour by hour, and how it takes turns with flows.

namespace {

using sim::Command;
using sim::CommandKind;
using support::Ground;
using support::Play;

constexpr float kDrySnow = 200;  // kg/m³

Command event(CommandKind kind, double at, double hours) {
    Command c;
    c.kind = kind;
    c.at = at, c.hours = hours;
    return support::of_its_kind(c);
}
Command storm(double at, double hours, double precipitation, double from = 290, double speed = 0,
              double warmer = -10) {
    Command c = event(CommandKind::kStorm, at, hours);
    c.precipitation = precipitation, c.wind_from = from, c.wind_speed = speed, c.warmer = warmer;
    return c;
}
Command temperature(double at, double hours, double warmer, double cloud) {
    Command c = event(CommandKind::kTemperature, at, hours);
    c.warmer = warmer, c.cloud = cloud;
    return c;
}
Command wind(double at, double hours, double from, double speed) {
    Command c = event(CommandKind::kWind, at, hours);
    c.wind_from = from, c.wind_speed = speed;
    return c;
}

sim::Calendar days(double count) {
    sim::Calendar calendar;
    calendar.hours = 24 * count;
    return calendar;
}

Ground snowy(Ground ground, const sim::Calendar& calendar) {
    ground.density = kDrySnow;
    ground.weather = calendar;
    return ground;
}

// A mountain range of hills and gullies, up to some 50 degrees, 600 m high.
Ground mountains(int squares, float dx, const sim::Calendar& calendar) {
    Ground ground(sim::Grid{squares + 1, squares + 1, dx});
    ground.set(ground.bedrock, [=](double x, double y) {
        const double size = squares * static_cast<double>(dx), u = x / size, v = y / size;
        return 600 * std::exp(-8 * (v - 0.55) * (v - 0.55)) * (0.75 + 0.25 * std::sin(9 * u + 2 * v)) +
               40 * std::sin(21 * u + 4 * std::sin(5 * v));
    });
    return snowy(ground, calendar);
}

// Gives commands in the first tick, and then lets pass so many hours, with the flows between them.
void pass(Play& play, std::int64_t hours, const std::vector<Command>& program = {}) {
    if (!program.empty()) play.ticks(1, program);
    while (play.state.weather->hours < hours) play.ticks(1);
}

TEST(Weather, of_no_events_changes_the_hour_alone_on_bare_ground) {
    Play play(snowy(support::plane(20, 5, 0.5), days(2)), support::loose_dry_snow());
    const sim::State before = play.state;
    play.ticks(30);
    EXPECT_EQ(play.state.weather->hours, 30);
    EXPECT_EQ(play.state.tick, 30);
    for (const auto field : {&sim::State::depth, &sim::State::rolling, &sim::State::velocity_x})
        EXPECT_TRUE(support::same_bits(play.state.*field, before.*field));
    EXPECT_FALSE(sim::at_rest(play.state));
    play.ticks(18);
    EXPECT_TRUE(sim::at_rest(play.state)) << "the calendar is over";
    play.ticks(1);
    EXPECT_EQ(play.state.weather->hours, 48);
}

TEST(Weather, belongs_to_the_hash_and_no_hash_changes_without_it) {
    Play with(snowy(support::plane(20, 5, 0.5), days(2)), support::loose_dry_snow());
    Ground ground = support::plane(20, 5, 0.5);
    ground.density = kDrySnow;
    Play without(ground, support::loose_dry_snow());
    EXPECT_NE(sim::state_hash(with.state), sim::state_hash(without.state));
    // Each member of the state.
    const auto changes = [&](const auto& change) {
        sim::State other = with.state;
        change(*other.weather);
        return sim::state_hash(other) != sim::state_hash(with.state);
    };
    EXPECT_TRUE(changes([](sim::Weather& w) { ++w.hours; }));
    EXPECT_TRUE(changes([](sim::Weather& w) { w.program.push_back({storm(1, 2, 3), 3}); }));
    EXPECT_TRUE(changes([](sim::Weather& w) { w.anchored = false; }));
    EXPECT_TRUE(changes([](sim::Weather& w) { w.stirred = 7; }));
    EXPECT_TRUE(changes([](sim::Weather& w) { w.greatest_motion = 7; }));
    for (const auto field : {&sim::Weather::base, &sim::Weather::strength, &sim::Weather::water,
                             &sim::Weather::surface, &sim::Weather::undisturbed})
        EXPECT_TRUE(changes([&](sim::Weather& w) { (w.*field)(3, 4) += 1; }));
}

// 12 mm of water in 6 hours at 12 degrees of frost, on level ground: 2 mm/h are 0.01 m/h of snow of 200 kg/m³.
TEST(Weather, snows_as_computed_by_hand) {
    Play play(snowy(support::plane(4, 50, 0), days(2)), support::loose_dry_snow());
    pass(play, 7, {storm(1, 6, 12)});
    EXPECT_NEAR(static_cast<double>(play.state.depth(2, 2)), 0.06, 6 * static_cast<double>(sim::kQuantum));
    EXPECT_EQ(play.state.weather->base(2, 2), 0);
    EXPECT_EQ(play.state.weather->surface(2, 2), -1) << "it has just snowed";
    EXPECT_EQ(play.state.ledger.fallen, play.state.ledger.standing);
    EXPECT_EQ(play.state.ledger.mass_error(), 0);
}

TEST(Weather, tells_what_was_brought_from_what_fell_until_snow_has_hidden_it) {
    Play play(snowy(support::plane(20, 5, 0), days(4)), support::loose_dry_snow());
    Command pour = support::pour_at(50, 50, 10, 12000, 0);
    pour.layer = sim::Layer::kStanding;
    play.ticks(1, std::vector{storm(1, 6, 12), storm(20, 40, 80), pour});
    const sim::Weather& w = *play.state.weather;
    const auto brought = [&] {
        return static_cast<double>(play.state.depth(10, 10) - w.undisturbed(10, 10));
    };
    const double poured = brought();
    ASSERT_GT(poured, 0.5);
    pass(play, 10);
    EXPECT_NEAR(brought(), poured - 2 * 0.06, 0.001);
    EXPECT_EQ(play.state.depth(0, 0), w.undisturbed(0, 0));
    pass(play, 40);
    EXPECT_NEAR(brought(), poured - 2 * (0.06 + 0.2), 0.001);
    pass(play, 60);
    EXPECT_EQ(brought(), 0);
    EXPECT_GT(play.state.depth(10, 10), 1);
}

// 1 December has a mean of 3.2 − 6 cos(−44 · 360°/365) = −1.2 degrees, and 12 K more here.
TEST(Weather, rains_above_two_degrees_and_melts_what_lies) {
    Ground ground = support::plane(4, 50, 0, 1);
    Play play(snowy(ground, days(4)), support::loose_dry_snow());
    const double start = play.state.ledger.standing;
    pass(play, 96, {storm(0, 24, 48, 0, 0, 12), temperature(24, 72, 12, 0)});
    EXPECT_EQ(play.state.ledger.mass_error(), 0);
    EXPECT_GT(play.state.ledger.melted, play.state.ledger.fallen) << "all rain, and more";
    EXPECT_LT(play.state.ledger.standing, 0.95 * start);
    const sim::Weather& w = *play.state.weather;
    EXPECT_GE(static_cast<double>(w.water(2, 2)), 0.1 * 200 * 0.3) << "it holds a tenth of its mass";
    EXPECT_LE(static_cast<double>(w.water(2, 2)), 0.1 * 200 * 0.3 + 0.01);
}

TEST(Weather, brings_more_with_height_and_less_to_steep_rock) {
    sim::Calendar calendar = days(1);
    Ground ground(sim::Grid{41, 21, 25});
    ground.set(ground.bedrock, [](double x, double) {
        return x < 300 ? 0.0 : x < 600 ? 2.5 * (x - 300) : 750.0;
    });
    Play play(snowy(ground, calendar), support::loose_dry_snow());
    play.ticks(1, std::vector{storm(0, 5, 50, 0, 0, -20)});
    play.ticks(5);
    const auto d = [&](int x) { return static_cast<double>(play.state.depth(x, 10)); };
    EXPECT_NEAR(d(4), 0.25, 1e-4);
    EXPECT_NEAR(d(35), 0.25 * (1 + 4e-4 * 750.125), 1e-3);
    EXPECT_LT(d(20), 0.2) << "on rock of 68 degrees a tenth stays, and a tenth of what comes from above";
    EXPECT_GT(d(12), 0.4) << "at its foot";
}

// Of 25 programs of eight events: storms, winds and changes of temperature.
TEST(Weather, keeps_mass_to_the_quantum_whatever_comes) {
    std::uint64_t seed = 1;
    for (int k = 0; k < 25; ++k) {
        Play play(mountains(24, 25, days(6)), support::loose_dry_snow());
        std::vector<Command> program;
        for (int i = 0; i < 8; ++i) {
            const auto next = [&](double least, double most) {
                seed = seed * 6364136223846793005u + 1442695040888963407u;
                return std::floor(least + (most - least) * static_cast<double>(seed >> 40) / 16777216);
            };
            const double at = next(0, 100), hours = next(1, 40);
            if (i % 4 == 3)
                program.push_back(temperature(at, hours, next(-10, 20), 0.5));
            else if (i % 4 == 2)
                program.push_back(wind(at, hours, next(0, 360), next(5, 30)));
            else
                program.push_back(storm(at, hours, next(0, 40), next(0, 360), next(0, 25), next(-12, 12)));
        }
        pass(play, 144, program);
        EXPECT_EQ(play.state.ledger.mass_error(), 0) << k;
        for (int y = 0; y < play.state.grid.ny; ++y)
            for (int x = 0; x < play.state.grid.nx; ++x) {
                const auto d = static_cast<double>(play.state.depth(x, y) / sim::kQuantum);
                ASSERT_EQ(d, std::floor(d));
                ASSERT_GE(d, 0);
                ASSERT_GE(play.state.weather->water(x, y), 0);
            }
    }
}

// A storm under clouds, which no sun reaches, in a world, in its mirrored one and in its turned one.
TEST(Weather, mirrors_and_turns_with_the_world) {
    const int n = 32;
    const auto height = [](double x, double y) {
        return 300 * std::exp(-((x - 300) * (x - 300) + 0.6 * (y - 420) * (y - 420)) / 40000) + 0.05 * x +
               0.02 * y;
    };
    const auto played = [&](const auto& of, double from) {
        Ground ground(sim::Grid{n + 1, n + 1, 25});
        ground.set(ground.bedrock, of);
        for (float& b : ground.bedrock) b = sim::nearest_quanta(b);
        Play play(snowy(ground, days(1)), support::loose_dry_snow());
        play.ticks(1, std::vector{storm(0, 11, 30, from, 16), temperature(0, 24, 0, 1)});
        play.ticks(11);
        return play.state.depth;
    };
    const double size = 25.0 * n;
    const sim::Field<float> plain = played(height, 290),
                            mirrored = played([&](double x, double y) { return height(size - x, y); }, 70),
                            turned = played([&](double x, double y) { return height(y, x); }, 160);
    int beside = 0, aside = 0;
    for (int y = 0; y <= n; ++y)
        for (int x = 0; x <= n; ++x) {
            beside += plain(x, y) != mirrored(n - x, y);
            aside += plain(x, y) != turned(y, x);
        }
    EXPECT_EQ(beside, 0);
    EXPECT_EQ(aside, 0);
}

TEST(Weather, drifts_from_the_windward_side_to_the_lee) {
    Ground ground(sim::Grid{81, 41, 12.5f});
    ground.set(ground.bedrock,
               [](double x, double) { return 200 * std::exp(-(x - 500) * (x - 500) / 20000); });
    const auto gained = [&](double speed) {
        Play play(snowy(ground, days(2)), support::loose_dry_snow());
        pass(play, 6, {storm(0, 6, 30, 270, 0)});
        play.ticks(1, std::vector{wind(6, 5, 270, speed)});
        const sim::Field<float> before = play.state.depth;
        pass(play, 11);
        EXPECT_EQ(play.state.ledger.mass_error(), 0);
        return std::pair(play.state.depth(36, 20) - before(36, 20),
                         play.state.depth(45, 20) - before(45, 20));
    };
    const auto [windward, lee] = gained(15);
    EXPECT_LT(windward, -0.005f);
    EXPECT_GT(lee, 0.01f);
    const auto [calm_windward, calm_lee] = gained(4);
    EXPECT_EQ(calm_windward, 0);
    EXPECT_EQ(calm_lee, 0);
}

// After any calm tick a flow of which nothing rolls changes no bit, with all tiles awake.
TEST(Weather, leaves_ground_on_which_no_flow_starts) {
    for (const std::int64_t hours : {5, 30, 71, 100}) {
        sim::Calendar calendar = days(30);
        calendar.hours = static_cast<double>(hours);
        sim::StepOptions options;
        options.tiles_may_sleep = false;
        Play play(mountains(48, 12.5f, calendar), support::loose_dry_snow(), options);
        std::vector<Command> program{storm(0, 20, 60, 290, 14), storm(40, 30, 80, 250, 18),
                                     temperature(72, 24, 6, 0)};
        std::erase_if(program, [&](const Command& each) { return each.at >= calendar.hours; });
        pass(play, hours, program);
        while (!sim::at_rest(play.state)) play.ticks(1);
        const sim::Field<float> before = play.state.depth;
        play.ticks(20);
        EXPECT_TRUE(support::same_bits(play.state.depth, before)) << hours;
        EXPECT_EQ(play.state.ledger.rolling, 0) << hours;
    }
}

std::vector<Command> winter() {
    return {storm(0, 12, 20, 290, 5), temperature(12, 72, -6, 0), storm(84, 30, 70, 290, 16),
            wind(114, 10, 300, 18), temperature(140, 60, 9, 0.1)};
}

TEST(Weather, lets_slabs_go_after_a_storm_on_hoar) {
    Play play(mountains(64, 12.5f, days(9)), support::loose_dry_snow());
    play.ticks(1, winter());
    std::int64_t hours_of_releases = 0;
    bool rolled = false;
    while (!sim::at_rest(play.state)) {
        play.ticks(1);
        const bool rolls = play.state.ledger.rolling > 0;
        if (rolls && !rolled) {
            ++hours_of_releases;
            EXPECT_EQ(play.state.weather->hours % 12, 0);
            EXPECT_GT(play.state.weather->hours, 84) << "before the storm nothing lies on a weak layer";
        }
        rolled = rolls;
    }
    EXPECT_GE(hours_of_releases, 1);
    EXPECT_EQ(play.state.ledger.mass_error(), 0);
}

// A storm on a plane whose only weak layer is the ground. Strength and load of each vertex are computed beside it, hour by hour.
TEST(Weather, lets_a_plane_of_38_degrees_go_when_it_must_and_none_of_27) {
    for (const auto& [degrees, water] : {std::pair(38., 480.), std::pair(27., 960.)}) {
        const double tangent = std::tan(degrees * std::acos(-1.) / 180), per_metre = 200 * 9.81;  // Pa
        Play play(snowy(support::plane(40, 12.5f, tangent), days(3)), support::loose_dry_snow());
        play.ticks(1, std::vector{storm(0, 48, water)});
        std::vector<double> strength(play.state.grid.size());
        int unstable = 0, looks_before = 0;
        for (int hour = 1; hour <= 48 && play.state.ledger.rolling == 0; ++hour) {
            play.ticks(1);
            ASSERT_EQ(play.state.weather->hours, hour);
            for (std::size_t i = 0; i < strength.size(); ++i) {
                const int x = static_cast<int>(i) % 41, y = static_cast<int>(i) / 41;
                const double slab = static_cast<double>(play.state.depth(x, y) + play.state.rolling(x, y));
                const double load = per_metre * slab / (1 + tangent * tangent);
                if (hour == 1)
                    strength[i] = static_cast<double>(play.state.weather->strength(x, y));
                else
                    strength[i] += std::max(700 + 1.2 * load - strength[i], 0.) / 40;
                if (hour % 12 != 0) continue;
                const double index = strength[i] / (load * tangent);
                unstable += index < 0.98;
                if (degrees < 28) continue;
                if (index < 0.98) {
                    EXPECT_GT(play.state.rolling(x, y), 0) << hour << ' ' << x << ' ' << y;
                }
                if (index > 1.37) {
                    EXPECT_EQ(play.state.rolling(x, y), 0) << hour << ' ' << x << ' ' << y;
                }
            }
            looks_before += hour % 12 == 0 && unstable == 0;
        }
        EXPECT_GT(unstable, 10) << degrees;
        EXPECT_TRUE(degrees < 28 || looks_before > 0) << "at first it holds";
        EXPECT_EQ(play.state.ledger.rolling > 0, degrees > 28);
    }
}

// Executors, instruction sets, threads and tiles; and after going back to the middle.
TEST(Weather, has_the_same_bits_however_it_is_run_and_after_going_back) {
    const auto run = [](const sim::StepOptions& options) {
        Play play(mountains(24, 25, days(9)), support::loose_dry_snow(), options);
        play.ticks(1, winter());
        std::vector<sim::Snapshot> kept;
        while (!sim::at_rest(play.state)) {
            play.ticks(1);
            const std::int64_t tick = play.state.tick;
            if (tick == 50 || tick == 150 || tick == 1203) kept.push_back(sim::take_snapshot(play.state));
        }
        const std::uint64_t hash = sim::state_hash(play.state);
        for (const sim::Snapshot& snapshot : kept) {
            if (options.plain) break;
            sim::restore(snapshot, play.state);
            while (!sim::at_rest(play.state)) play.ticks(1);
            EXPECT_EQ(sim::state_hash(play.state), hash) << "from tick " << snapshot.tick;
        }
        return std::pair(hash, play.state.tick);
    };
    const auto known = run({});
    EXPECT_GT(known.second, 9 * 24 + 60) << "something slid";
    for (const sim::InstructionSet set : sim::kInstructionSets)
        if (sim::has(set)) {
            EXPECT_EQ(run({.threads = 2, .instruction_set = set}), known) << sim::to_string(set);
        }
    EXPECT_EQ(run({.plain = true}), known);
    EXPECT_EQ(run({.threads = 3, .tile_width = 32, .tile_height = 8, .last_tile_first = true}), known);
    EXPECT_EQ(run({.tiles_may_sleep = false}), known);
}

TEST(Weather, refuses_what_cannot_be) {
    const sim::Params snow = support::loose_dry_snow();
    sim::Calendar calendar = days(2);
    EXPECT_FALSE(sim::fault_of(calendar, snow, 200, false));
    sim::Params other = snow;
    other.model = sim::Model::kVoellmy;
    EXPECT_EQ(sim::fault_of(calendar, other, 200, false),
              "weather needs model bcre-inertial: in voellmy nothing is deposited");
    EXPECT_EQ(sim::fault_of(calendar, snow, 200, true), "weather needs a world of one material");
    EXPECT_EQ(sim::fault_of(calendar, snow, 0, false),
              "weather needs a material whose density is known and at least 50 kg/m3");
    calendar.hours = 0.5;
    EXPECT_EQ(sim::fault_of(calendar, snow, 200, false), "weather's hours is 0.5 h, outside 1 to 8784");
    calendar.hours = 48, calendar.latitude = std::nan("");
    EXPECT_TRUE(sim::fault_of(calendar, snow, 200, false));

    sim::Weather weather(days(2), sim::Field<float>());
    weather.hours = 10;
    const auto fault = [&](const std::vector<Command>& commands) {
        const auto wrong = sim::fault_of_weather(&weather, commands);
        return wrong ? wrong->fact : "";
    };
    Command cancel;
    cancel.kind = CommandKind::kCancel;
    cancel.event = 1;
    EXPECT_EQ(sim::fault_of_weather(nullptr, std::vector{storm(1, 2, 3)})->fact,
              "storm: this world has no weather");
    EXPECT_EQ(fault({storm(9, 2, 3)}), "storm: hour 9 is over");
    EXPECT_EQ(fault({storm(48, 2, 3)}), "storm: hour 48 is beyond the calendar of 48 h");
    EXPECT_EQ(fault({cancel}), "cancel: there is no event 1, of 0");
    EXPECT_EQ(fault({storm(12, 2, 3), cancel}), "");
    EXPECT_EQ(fault({storm(12, 2, 3), cancel, cancel}), "cancel: event 1 is over");
    EXPECT_EQ(fault({storm(12, 9, 9 * 50), storm(14, 2, 2 * 50)}), "");
    EXPECT_EQ(fault({storm(14, 2, 2 * 50), storm(15, 9, 9 * 50), storm(12, 9, 9)}),
              "storm: over 100 mm of water would fall in hour 15");
    EXPECT_EQ(fault(std::vector<Command>(1001, storm(12, 9, 0))),
              "storm: there are 1000 events already, which is the most");
    EXPECT_EQ(sim::fault_of(storm(1.5, 2, 3)), "storm's at is 1.5 h, not a whole number");
    EXPECT_EQ(sim::fault_of(storm(1, 2, 300)), "storm's precipitation is 150 mm an hour, above 50");
}

// A world of one cell, and one without any ground.
TEST(Weather, falls_on_a_world_of_one_cell) {
    Ground ground(sim::Grid{2, 2, 10});
    Play play(snowy(ground, days(1)), support::loose_dry_snow());
    pass(play, 24, {storm(0, 24, 48, 300, 20)});
    EXPECT_EQ(play.state.ledger.mass_error(), 0);
    EXPECT_GT(play.state.ledger.standing, 0);
    std::fill(ground.has_data.begin(), ground.has_data.end(), std::uint8_t{0});
    Play nowhere(snowy(ground, days(1)), support::loose_dry_snow());
    pass(nowhere, 24, {storm(0, 24, 48, 300, 20)});
    EXPECT_EQ(nowhere.state.ledger.standing, 0);
    EXPECT_EQ(nowhere.state.ledger.mass_error(), 0);
}

}  // namespace
