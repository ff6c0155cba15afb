#include "sim/world/command.h"
#include "sim/sweep/count_mass.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include <gtest/gtest.h>

#include "sim/world/snapshot.h"
#include "tests/support/worlds.h"

namespace {

using sim::Command;
using sim::CommandKind;
using support::Play;

// A flat world in which nothing moves on its own.
Play flat(double depth = 0, int squares = 40, float dx = 1) {
    sim::Params params = support::lively(sim::Model::kBcreInertial);
    params.start_slope = 9;
    return Play(support::plane(squares, dx, 0, depth), params);
}

double cubic_metres(const Play& play, std::int64_t quanta) {
    return static_cast<double>(quanta) * static_cast<double>(sim::kQuantum) * play.state.grid.cell_area();
}

TEST(Pour, adds_its_volume_on_any_grid_in_both_profiles) {
    for (const float dx : {0.5f, 1.f, 2.f})
        for (const auto profile : {sim::Profile::kDisc, sim::Profile::kCone}) {
            Play play = flat(0, static_cast<int>(40 / dx), dx);
            Command pour = support::pour_at(20.3, 19.1, 6, 50, 1.5);
            pour.profile = profile;
            pour.layer = sim::Layer::kStanding;
            play.ticks(120, {&pour, 1});
            EXPECT_NEAR(cubic_metres(play, play.state.ledger.poured), 75, 0.01) << dx;
            EXPECT_TRUE(play.state.running_commands.empty());
        }
}

TEST(Pour, adds_equally_each_tick_and_then_stops) {
    Play play = flat();
    Command pour = support::pour_at(20, 20, 5, 60, 1);
    pour.layer = sim::Layer::kStanding;
    play.ticks(30, {&pour, 1});
    EXPECT_NEAR(cubic_metres(play, play.state.ledger.poured), 30, 0.01);
    EXPECT_EQ(play.state.running_commands.size(), 1u);
    play.ticks(90);
    EXPECT_NEAR(cubic_metres(play, play.state.ledger.poured), 60, 0.01);
}

TEST(Pour, into_the_rolling_layer_starts_at_rest) {
    Play play = flat();
    play.state.rolling(20, 20) = 0.5f;
    play.state.velocity_x(20, 20) = 2;
    const Command pour = support::pour_at(20, 20, 0, 30, 0);  // less than a cell: the nearest vertex
    sim::apply_commands(play.state, {&pour, 1});
    EXPECT_EQ(play.state.rolling(20, 20), 1.f);
    EXPECT_EQ(play.state.velocity_x(20, 20), 1.f);
}

TEST(Pour, outside_the_world_or_on_no_data_adds_nothing) {
    support::Ground ground = support::plane(20, 1, 0);
    ground.has_data[ground.at(10, 10)] = 0;
    Play play(ground, support::lively(sim::Model::kBcreInertial));
    const Command commands[] = {support::pour_at(-50, 5, 10, 100, 0), support::pour_at(10, 10, 0, 100, 0)};
    sim::apply_commands(play.state, commands);
    EXPECT_EQ(play.state.ledger.poured, 0);
    EXPECT_EQ(play.state.rolling(10, 10), 0);
}

TEST(Pour, half_over_the_border_keeps_the_half_inside) {
    Play play = flat();
    Command pour = support::pour_at(-0.5, 20, 8, 60, 1);
    pour.layer = sim::Layer::kStanding;
    play.ticks(60, {&pour, 1});
    EXPECT_NEAR(cubic_metres(play, play.state.ledger.poured), 30, 0.5);
}

TEST(Pour, fills_a_vertex_to_half_the_depth_limit_at_most) {
    Play play = flat();
    Command pour = support::pour_at(20, 20, 0, 1e8, 0);
    pour.layer = sim::Layer::kStanding;
    sim::apply_commands(play.state, {&pour, 1});
    EXPECT_EQ(play.state.depth(20, 20), sim::kDeepest / 2);
    sim::count_mass(play.state);
    EXPECT_EQ(play.state.ledger.mass_error(), 0);
}

TEST(Dig, takes_the_rolling_layer_first_and_never_bedrock) {
    Play play = flat(0.25);
    play.state.rolling(20, 20) = 0.5f;
    sim::count_mass(play.state);
    play.state.ledger.initial = play.state.ledger.standing + play.state.ledger.rolling;
    Command dig;
    dig.kind = CommandKind::kDig;
    dig.x = dig.y = 20;
    dig.radius = 3;
    dig.rate = 36;  // 0.6 m per tick
    sim::apply_commands(play.state, {&dig, 1});
    EXPECT_EQ(play.state.rolling(20, 20), 0);
    EXPECT_NEAR(play.state.depth(20, 20), 0.15, 1e-5);
    EXPECT_EQ(play.state.depth(21, 20), 0);
    sim::count_mass(play.state);
    EXPECT_EQ(play.state.ledger.mass_error(), 0);
}

TEST(Blast, releases_the_erodible_layer_up_to_its_depth) {
    Play play = flat(1);
    Command blast;
    blast.kind = CommandKind::kBlast;
    blast.x = blast.y = 20;
    blast.radius = 3;
    blast.depth = 0.75;
    sim::apply_commands(play.state, {&blast, 1});
    EXPECT_EQ(play.state.rolling(20, 20), 0.75f);
    EXPECT_EQ(play.state.depth(20, 20), 0.25f);
    EXPECT_EQ(play.state.rolling(24, 20), 0);
    EXPECT_TRUE(play.state.running_commands.empty());
}

TEST(Commands, manifest_is_in_the_order_of_the_kinds) {
    for (const sim::CommandInfo& info : sim::kCommands) {
        EXPECT_EQ(&sim::info_of(info.kind), &info);
        EXPECT_EQ(sim::command_from(info.name)->kind, info.kind);
    }
    EXPECT_FALSE(sim::command_from("melt"));
}

TEST(Commands, refuse_and_name_every_number_out_of_range) {
    for (const sim::CommandInfo& info : sim::kCommands)
        for (const sim::CommandNumber& number : info.numbers)
            for (const double bad :
                 {std::nextafter(number.least, -1e300) - 1, number.most * 1.001 + 1, std::nan("")}) {
                Command command;
                command.kind = info.kind;
                for (const sim::CommandNumber& each : info.numbers)
                    command.*each.value = std::clamp(1.0, each.least, each.most);
                if (info.has_param) command.param = sim::param_from("start_depth").value();
                ASSERT_FALSE(sim::fault_of(command));
                command.*number.value = bad;
                const auto fault = sim::fault_of(command);
                ASSERT_TRUE(fault) << info.name << " " << number.name;
                EXPECT_NE(fault->find(number.name), std::string::npos);
            }
}

TEST(Commands, refuse_in_numbers_as_people_write_them) {
    Command sculpt;
    sculpt.kind = CommandKind::kSculpt;
    sculpt.rise = 31;
    EXPECT_EQ(sim::fault_of(sculpt), "sculpt's rise is 31 m, outside -30 to 30");
    sculpt.rise = 1, sculpt.radius = 250'000;
    EXPECT_EQ(sim::fault_of(sculpt), "sculpt's radius is 250 000 m, outside 0 to 100 000");
}

TEST(Settle, deposits_the_rolling_layer_within_its_disc_and_conserves_mass) {
    Play play = flat(1);
    const Command pour = support::pour_at(20, 20, 8, 600, 0);
    sim::apply_commands(play.state, {&pour, 1});
    ASSERT_GT(play.state.rolling(20, 20), 0.f);
    play.state.velocity_x(20, 20) = 3;
    const float outside = play.state.rolling(26, 20),
                all = play.state.depth(20, 20) + play.state.rolling(20, 20);
    ASSERT_GT(outside, 0.f);
    Command settle;
    settle.kind = CommandKind::kSettle;
    settle.x = settle.y = 20;
    settle.radius = 4;
    sim::apply_commands(play.state, {&settle, 1});
    EXPECT_EQ(play.state.rolling(20, 20), 0.f);
    EXPECT_EQ(play.state.velocity_x(20, 20), 0.f);
    EXPECT_EQ(play.state.depth(20, 20), all);
    EXPECT_EQ(play.state.rolling(26, 20), outside);
    EXPECT_TRUE(play.state.running_commands.empty());
    play.ticks(1);
    EXPECT_EQ(play.state.ledger.mass_error(), 0);
}

Command set_to(std::string_view param, double value) {
    Command set;
    set.kind = CommandKind::kSet;
    set.param = sim::param_from(param).value();
    set.value = value;
    return set;
}

TEST(Settle, never_exceeds_the_depth_limit) {
    Play play = flat(1);
    for (int i = 0; i < 4; ++i) {
        const Command pour = support::pour_at(20, 20, 3, 1e6, 0);
        sim::apply_commands(play.state, {&pour, 1});
        Command settle;
        settle.kind = CommandKind::kSettle;
        settle.x = settle.y = 20;
        settle.radius = 2;
        sim::apply_commands(play.state, {&settle, 1});
        ++play.state.tick;
    }
    EXPECT_LE(play.state.depth(20, 20), sim::kDeepest / 2);
    EXPECT_LE(play.state.rolling(20, 20), sim::kDeepest / 2);
    play.state.tick = 0;
    play.ticks(1);
    EXPECT_EQ(play.state.ledger.mass_error(), 0);
}

TEST(Set, acts_from_its_own_tick_and_is_part_of_a_snapshot) {
    Play play = flat(1);
    const sim::Snapshot before = sim::take_snapshot(play.state);
    const Command set = set_to("stop_slope", 0.625);
    play.ticks(1, {&set, 1});
    EXPECT_EQ(play.state.params.stop_slope, 0.625f);
    EXPECT_TRUE(play.state.running_commands.empty());
    sim::restore(before, play.state);
    EXPECT_NE(play.state.params.stop_slope, 0.625f);
}

TEST(Set, of_start_slope_and_anchor_releases_ground_that_held) {
    // Steep from the start, so the anchor holds it. Without the anchor it is above the start slope.
    sim::Params params = support::lively(sim::Model::kBcreInertial);
    params.anchor_gain = 2;
    Play play(support::plane(20, 1, 0.6, 1), params);
    play.ticks(10);
    ASSERT_EQ(play.state.ledger.rolling, 0);
    const Command sets[] = {set_to("start_slope", 0.5), set_to("anchor_gain", 0), set_to("anchor_step", 0)};
    play.ticks(1, sets);
    EXPECT_GT(play.state.ledger.rolling, 0);
}

TEST(Set, is_checked_with_all_others_of_its_tick) {
    const sim::Params params = support::lively(sim::Model::kBcreInertial);
    const Command much = set_to("friction", 0.8), more = set_to("friction_thin", 0.9),
                  steeper = set_to("loose_slope", 0.9), higher = set_to("start_slope", 0.9);
    EXPECT_TRUE(sim::fault_after(params, {&much, 1}));
    const Command both[] = {much, more, steeper, higher};
    EXPECT_FALSE(sim::fault_after(params, both));
    EXPECT_FALSE(sim::fault_after(params, {}));
}

// A command of this kind with a valid value in each member that the kind uses.
Command sound(const sim::CommandInfo& info) {
    Command command;
    command.kind = info.kind;
    for (const sim::CommandNumber& number : info.numbers)
        command.*number.value = std::clamp(number.whole ? 1 : 0.25, number.least, number.most);
    if (info.has_param) command.param = sim::param_from("start_depth").value();
    return command;
}

TEST(Command, is_refused_with_a_member_that_its_kind_does_not_use) {
    std::vector<double Command::*> numbers;
    for (const sim::CommandInfo& info : sim::kCommands)
        for (const sim::CommandNumber& number : info.numbers) numbers.push_back(number.value);
    for (const sim::CommandInfo& info : sim::kCommands) {
        const Command command = sound(info);
        ASSERT_FALSE(sim::fault_of(command)) << *sim::fault_of(command);
        const auto refused = [&](auto Command::*member, auto value) {
            Command changed = command;
            changed.*member = value;
            return sim::fault_of(changed).has_value();
        };
        for (const auto member : numbers) {
            const auto used = std::find_if(info.numbers.begin(), info.numbers.end(),
                                           [&](const auto& number) { return number.value == member; });
            const bool is_used = used != info.numbers.end();
            const double other = is_used && used->whole ? 2 : 0.5;
            EXPECT_EQ(refused(member, is_used ? std::clamp(other, used->least, used->most) : other), !is_used)
                << info.name;
            // -0 and 0 have different bits, which the state hash sees.
            if (Command{}.*member == 0 && !(is_used && used->least > 0)) {
                EXPECT_EQ(refused(member, -0.0), !is_used) << info.name;
            }
        }
        EXPECT_EQ(refused(&Command::least_slope, 10.0), !info.has_slope) << info.name;
        EXPECT_EQ(refused(&Command::layer, sim::Layer::kStanding), !info.has_layer) << info.name;
        EXPECT_EQ(refused(&Command::profile, sim::Profile::kCone), !info.has_profile) << info.name;
        EXPECT_EQ(refused(&Command::of, sim::Part::kLower), !info.has_part) << info.name;
        EXPECT_EQ(refused(&Command::param, sim::param_from("stop_slope").value()), !info.has_param)
            << info.name;
        EXPECT_TRUE(refused(&Command::kind, static_cast<CommandKind>(std::size(sim::kCommands))))
            << info.name;
        EXPECT_TRUE(refused(&Command::param, std::size(sim::kParams))) << info.name;
    }
}

}  // namespace
