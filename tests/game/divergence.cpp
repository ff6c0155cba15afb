#include "game/recording/divergence.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "game/recording/divergence_report.h"
#include "game/recording/scenario_difference.h"
#include "sim/named_fields.h"
#include "sim/scratch.h"
#include "tests/game/recording_files.h"

namespace game::test {
namespace {

constexpr std::int64_t kComparedTicks = 12;

Scenario scenario_of(sim::Model model, sim::Scheme scheme) {
    Scenario scenario = small_scenario();
    scenario.params.model = model;
    scenario.params.scheme = scheme;
    return scenario;
}

sim::StepOptions plainly(int threads = 1) {
    return {.threads = threads, .plain = true};
}

// One value of one field, changed by this many ULPs after a stage.
struct Plant {
    const char* name;
    sim::Model model;
    sim::Scheme scheme;
    std::int64_t tick;
    int substep, number;
    const char* stage;
    const char* field;
    int x, y;
    std::int32_t ulps;
};

void plant(const Plant& fault, const Side::Moment& at) {
    if (at.tick != fault.tick || at.substep != fault.substep || at.number != fault.number) return;
    EXPECT_EQ(at.stage, fault.stage);
    auto fields = sim::fields_of(at.state);
    for (const auto& field : sim::fields_of(*at.scratch)) fields.push_back(field);
    const auto meant = std::find_if(fields.begin(), fields.end(),
                                    [&](const sim::NamedField& field) { return field.name == fault.field; });
    ASSERT_NE(meant, fields.end()) << fault.field;
    float& value = const_cast<sim::Field<float>&>(*meant->values)(fault.x, fault.y);
    value = std::bit_cast<float>(std::bit_cast<std::int32_t>(value) + fault.ulps);
}

constexpr auto kInertial = sim::Model::kBcreInertial;
constexpr auto kBcre = sim::Model::kBcre;
constexpr auto kLocal = sim::Scheme::kLocalLaxFriedrichs;

// A stage's intermediate results are finally rounded to whole quanta, which would lose a single ULP, so these
// faults are larger. Faults in a state's fields are one ULP.
constexpr std::int32_t kMany = 1 << 22;
const Plant kPlants[] = {
    {"commands_depth", kInertial, kLocal, 3, -1, 1, "commands", "depth", 4, 5, 1},
    {"driven", kInertial, kLocal, 5, 0, 3, "drive", "driven_v", 6, 8, kMany},
    {"exchange", kInertial, kLocal, 4, 0, 4, "exchange", "fed", 6, 7, kMany},
    {"flux", kInertial, kLocal, 6, 0, 7, "find_fluxes_y", "flux_y", 6, 7, kMany},
    {"moved", kInertial, kLocal, 6, 0, 11, "finish", "moved_rolling", 6, 7, kMany},
    {"after_transport", kInertial, kLocal, 2, 0, 12, "find_quiet", "moved_depth", 6, 7, kMany},
    {"yield", kInertial, kLocal, 7, 0, 13, "yield", "rolling", 6, 6, 1},
    {"first_drop", kBcre, kLocal, 1, 0, 2, "find_drops", "u0.drop_y", 6, 7, kMany},
    {"outflow", kBcre, kLocal, 5, 0, 4, "find_outflow", "outflow", 6, 7, kMany},
    {"settle", kBcre, kLocal, 9, 0, 6, "settle", "depth", 0, 10, 1},
    {"velocity", kBcre, kLocal, 9, 1, 3, "find_velocity", "velocity_x", 6, 7, 1},
    {"share", kBcre, sim::Scheme::kMuscl, 4, 0, 14, "find_share", "share", 6, 7, -kMany},
    {"lax_flux", kBcre, sim::Scheme::kLaxFriedrichs, 4, 0, 5, "find_quarter_fluxes", "flux_y", 6, 7, kMany},
};

class PlantedFault : public testing::TestWithParam<Plant> {};

TEST_P(PlantedFault, is_found_at_its_tick_stage_field_and_cell) {
    const Plant& fault = GetParam();
    const Scenario scenario = scenario_of(fault.model, fault.scheme);
    const auto commands = some_commands();
    const Side sound{scenario, commands, plainly(2), nullptr};
    const Side faulty{scenario, commands, plainly(), [&](const Side::Moment& at) { plant(fault, at); }};
    for (const bool second : {true, false}) {
        const auto parted = second ? first_divergence(sound, faulty, kComparedTicks)
                                   : first_divergence(faulty, sound, kComparedTicks);
        ASSERT_TRUE(parted);
        EXPECT_EQ(parted->where, Divergence::Where::kStage);
        EXPECT_EQ(parted->tick, fault.tick);
        EXPECT_EQ(parted->substep, fault.substep);
        EXPECT_EQ(parted->stage, fault.number);
        EXPECT_EQ(parted->name, fault.stage);
        ASSERT_EQ(parted->fields.size(), 1u) << to_text(*parted, scenario, {"a", "b"});
        const FieldDifference& found = parted->fields[0];
        EXPECT_EQ(found.field, fault.field);
        EXPECT_EQ(found.x, fault.x);
        EXPECT_EQ(found.y, fault.y);
        EXPECT_EQ(found.count, 1u);
        EXPECT_EQ(found.ulps, static_cast<std::uint64_t>(std::abs(fault.ulps)));
        const auto apart = std::bit_cast<std::int32_t>(found.values[second].bits) -
                           std::bit_cast<std::int32_t>(found.values[!second].bits);
        EXPECT_EQ(apart, fault.ulps);
        EXPECT_EQ(std::bit_cast<std::uint32_t>(found.values[0].number), found.values[0].bits);
        EXPECT_GT(differing(*parted), 0u);
    }
}

INSTANTIATE_TEST_SUITE_P(Stages, PlantedFault, testing::ValuesIn(kPlants),
                         [](const auto& fault) { return std::string(fault.param.name); });

TEST(Divergence, of_equal_runs_is_none_in_either_model_and_every_scheme_swept_or_plain) {
    const auto commands = some_commands();
    for (const auto model : {kInertial, kBcre})
        for (const auto scheme : {sim::Scheme::kLaxFriedrichs, kLocal, sim::Scheme::kMuscl}) {
            const Scenario scenario = scenario_of(model, scheme);
            const Side swept{scenario, commands, {}, nullptr};
            const Side otherwise{scenario,
                                 commands,
                                 {.threads = 3, .tile_width = 32, .tile_height = 8, .last_tile_first = true},
                                 nullptr};
            EXPECT_FALSE(first_divergence(swept, otherwise, 60));
            EXPECT_FALSE(first_divergence(swept, {scenario, commands, plainly(2), nullptr}, 60));
        }
}

TEST(Divergence, of_a_sweep_is_reported_with_the_run_at_fault) {
    const Scenario scenario = small_scenario();
    const auto commands = some_commands();
    const auto fault = [](const Side::Moment& at) {
        if (at.tick == 8 && at.stage == "sweep")
            at.state.velocity_x(5, 9) = std::nextafter(at.state.velocity_x(5, 9), 1e9f);
    };
    const Side sound{scenario, commands, {}, nullptr}, faulty{scenario, commands, {}, fault};
    const auto second = first_divergence(sound, faulty, kComparedTicks),
               first = first_divergence(faulty, sound, kComparedTicks);
    for (const auto& [parted, side] : {std::pair{second, 1}, std::pair{first, 0}}) {
        ASSERT_TRUE(parted);
        EXPECT_EQ(parted->where, Divergence::Where::kSweep);
        EXPECT_EQ(parted->tick, 8);
        EXPECT_EQ(parted->wrong_side, side);
        ASSERT_EQ(parted->fields.size(), 1u);
        EXPECT_EQ(parted->fields[0].field, "velocity_x");
        EXPECT_EQ(parted->fields[0].x, 5);
        EXPECT_EQ(parted->fields[0].y, 9);
        EXPECT_EQ(differing(*parted), 1u);
    }
}

TEST(Divergence, that_is_intermittent_is_reported_as_such) {
    const Scenario scenario = small_scenario();
    const auto commands = some_commands();
    bool done = false;
    const auto once = [&](const Side::Moment& at) {
        if (at.tick != 4 || at.stage != "yield" || done) return;
        done = true;
        at.state.depth(4, 5) += 1;
    };
    const auto parted = first_divergence({scenario, commands, plainly(), nullptr},
                                         {scenario, commands, plainly(), once}, kComparedTicks);
    ASSERT_TRUE(parted);
    EXPECT_EQ(parted->where, Divergence::Where::kLost);
    EXPECT_EQ(parted->tick, 4);
    EXPECT_EQ(parted->fields.at(0).field, "rolling");  // what was added is loose, and starts
}

TEST(Divergence, of_another_command_is_found_at_the_commands_of_its_tick) {
    const Scenario scenario = small_scenario();
    const auto commands = some_commands();
    auto moved = commands;
    moved[1].command.x += 2;
    const auto parted =
        first_divergence({scenario, commands, {}, nullptr}, {scenario, moved, {}, nullptr}, kComparedTicks);
    ASSERT_TRUE(parted);
    EXPECT_EQ(parted->where, Divergence::Where::kStage);
    EXPECT_EQ(parted->tick, 3);
    EXPECT_EQ(parted->name, "commands");
    EXPECT_EQ(
        differences_of(commands, moved),
        std::vector<std::string>{
            "at tick 3 the dig's x is 12.933333333333334 in the first and 14.933333333333334 in the second"});
}

TEST(Divergence, of_soil_that_is_wet_in_one_run_names_the_water) {
    Scenario scenario = small_scenario();
    scenario.density = 1800;
    sim::Command shower;
    shower.kind = sim::CommandKind::kWet;
    shower.x = 12, shower.y = 10, shower.radius = 1.5, shower.rate = 0.1;
    for (const bool second : {true, false}) {
        const std::vector<TimedCommand> none, one{{4, shower}};
        const auto parted = first_divergence({scenario, second ? none : one, {}, nullptr},
                                             {scenario, second ? one : none, {}, nullptr}, kComparedTicks);
        ASSERT_TRUE(parted);
        EXPECT_EQ(parted->tick, 4);
        EXPECT_EQ(parted->name, "commands");
        ASSERT_EQ(parted->fields.size(), 1u);
        EXPECT_EQ(parted->fields[0].field, "water");
        EXPECT_EQ(parted->fields[0].count, 1u);
        EXPECT_EQ(differing(*parted), 1u);
    }
}

TEST(Divergence, of_a_longer_running_source_is_found_before_any_field_differs) {
    const Scenario scenario = small_scenario();
    const auto commands = some_commands();
    auto longer = commands;
    longer[0].command.duration *= 2;
    const auto parted =
        first_divergence({scenario, commands, {}, nullptr}, {scenario, longer, {}, nullptr}, kComparedTicks);
    ASSERT_TRUE(parted);
    EXPECT_EQ(parted->tick, 0);
    EXPECT_EQ(parted->name, "commands");
    EXPECT_TRUE(parted->fields.empty());
}

TEST(Divergence, of_the_start_is_reported_before_any_tick) {
    const Scenario scenario = small_scenario();
    Scenario deeper = scenario;
    deeper.depth[deeper.depth.size() - 1] += 0.5f;
    const auto parted =
        first_divergence({scenario, {}, {}, nullptr}, {deeper, {}, {}, nullptr}, kComparedTicks);
    ASSERT_TRUE(parted);
    EXPECT_EQ(parted->where, Divergence::Where::kStart);
    EXPECT_EQ(parted->tick, 0);
    EXPECT_EQ(parted->fields.at(0).field, "depth");
    EXPECT_EQ(parted->fields.at(0).x, 12);
    EXPECT_EQ(parted->fields.at(0).y, 10);
    EXPECT_EQ(differences_of(scenario, deeper),
              std::vector<std::string>{"the cover's depth differs at 1 vertices"});
}

TEST(Divergence, of_other_parameters_is_found_at_the_stage_that_uses_them) {
    const Scenario scenario = scenario_of(kInertial, kLocal);
    Scenario quicker = scenario;
    quicker.params.drag *= 0.5f;
    const auto parted =
        first_divergence({scenario, {}, {}, nullptr}, {quicker, {}, {}, nullptr}, kComparedTicks);
    ASSERT_TRUE(parted);
    EXPECT_EQ(parted->name, "drive");
    EXPECT_EQ(differences_of(scenario, quicker),
              std::vector<std::string>{"drag is 400 in the first and 200 in the second"});
}

TEST(Divergence, of_other_stages_is_reported_without_a_stage) {
    const Scenario scenario = scenario_of(kBcre, kLocal), other = scenario_of(kBcre, sim::Scheme::kMuscl);
    const auto parted =
        first_divergence({scenario, {}, {}, nullptr}, {other, {}, {}, nullptr}, kComparedTicks);
    ASSERT_TRUE(parted);
    EXPECT_EQ(parted->where, Divergence::Where::kElse);
    EXPECT_FALSE(parted->fields.empty());
}

TEST(Divergence, names_the_run_that_does_not_take_its_commands) {
    const Scenario scenario = small_scenario();
    sim::Command tiny;
    tiny.radius = -1;
    const std::vector<TimedCommand> faulty{{4, tiny}};
    const Side sound{scenario, {}, {}, nullptr}, wrong{scenario, faulty, {}, nullptr};
    for (const bool second : {false, true}) {
        const auto parted = second ? first_divergence(sound, wrong, kComparedTicks)
                                   : first_divergence(wrong, sound, kComparedTicks);
        ASSERT_TRUE(parted);
        EXPECT_EQ(parted->where, Divergence::Where::kRefused);
        EXPECT_EQ(parted->tick, 4);
        EXPECT_EQ(parted->wrong_side, second ? 1 : 0);
        EXPECT_NE(to_text(*parted, scenario, {"one", "other"}).find("radius"), std::string::npos);
        EXPECT_EQ(to_json(*parted, scenario)["where"], "refused");
    }
}

TEST(StartDifference, is_empty_for_equal_scenarios_and_ignores_appearance) {
    const Scenario scenario = small_scenario();
    Scenario seen = scenario;
    seen.light.azimuth_deg += 1, seen.look.flow.reset(), seen.title = "another";
    EXPECT_TRUE(differences_of(scenario, seen).empty());
    EXPECT_TRUE(differences_of(some_commands(), some_commands()).empty());
}

TEST(StartDifference, names_a_command_that_only_one_has) {
    const auto commands = some_commands();
    auto without = commands;
    without.erase(without.begin() + 3);
    EXPECT_EQ(differences_of(commands, without),
              std::vector<std::string>{"only the first has, at tick 20: " + to_text(commands[3].command)});
}

TEST(Ulps, count_the_floats_between) {
    const float inf = std::numeric_limits<float>::infinity();
    EXPECT_EQ(ulps_between(1, 1), 0u);
    EXPECT_EQ(ulps_between(1, std::nextafter(1.f, 2.f)), 1u);
    EXPECT_EQ(ulps_between(-1, std::nextafter(-1.f, 0.f)), 1u);
    EXPECT_EQ(ulps_between(0.f, -0.f), 1u);
    EXPECT_EQ(ulps_between(std::nextafter(0.f, 1.f), std::nextafter(0.f, -1.f)), 3u);
    EXPECT_EQ(ulps_between(1, 2), 1u << 23);
    EXPECT_EQ(ulps_between(std::numeric_limits<float>::max(), inf), 1u);
    EXPECT_EQ(ulps_between(-inf, inf), 2 * std::uint64_t{0x7f800000} + 1);
}

TEST(DivergenceReport, names_tick_stage_field_tile_cell_bits_and_distance) {
    const Plant fault = kPlants[0];
    const Scenario scenario = scenario_of(fault.model, fault.scheme);
    const auto parted = first_divergence(
        {scenario, {}, plainly(), nullptr},
        {scenario, {}, plainly(), [&](const Side::Moment& at) { plant(fault, at); }}, kComparedTicks);
    ASSERT_TRUE(parted);
    const std::string text = to_text(*parted, scenario, {"sound", "faulty"});
    for (const char* told :
         {"tick 3 (at 0.05 s)", "commands, before the first sub-step", "depth, 1 value",
          "4, 5: 8.4 m east, 10.5 m north", "0, 0 of 64x32 vertices", "1 ULP\n", "sound ", "faulty "})
        EXPECT_NE(text.find(told), std::string::npos) << told << " in\n" << text;
    const Json json = to_json(*parted, scenario);
    EXPECT_EQ(json["tick"], 3);
    EXPECT_EQ(json["stage"]["name"], "commands");
    EXPECT_EQ(json["fields"][0]["cell"], Json({4, 5}));
    EXPECT_EQ(json["fields"][0]["ulps"], 1);
}

}  // namespace
}  // namespace game::test
