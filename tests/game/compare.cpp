#include "game/compare/comparison.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "game/compare/desync_picture.h"
#include "game/compare/difference_map.h"
#include "game/compare/edit.h"
#include "game/recording/recording_file.h"
#include "game/recording/scenario_difference.h"
#include "game/session/verifier.h"
#include "tests/game/program.h"
#include "tests/game/recording_files.h"
#include "tests/support/places.h"

namespace game::test {
namespace {

using Arguments = std::vector<std::string>;

constexpr int kTicks = 40;

Recording recording_of(const std::vector<TimedCommand>& commands) {
    Recording recording;
    recording.header.scenario = small_scenario();
    recording.commands = commands;
    recording.end = kTicks;
    return recording;
}

// A recording of small_start(), and the output of the subcommands for it.
class Compared : public testing::Test {
  protected:
    Compared() { record(first_, small_scenario(), kTicks, some_commands()); }

    std::string file(const char* name) const { return (folder_.path() / name).string(); }

    static Json json_of(const Arguments& arguments) {
        const Finished finished = couloir(arguments);
        EXPECT_EQ(finished.status, 0) << finished.err;
        return Json::parse(finished.out);
    }

    // Expects status 2, one sentence that contains `told`, and no leftover files.
    void refused(const Arguments& arguments, const std::string& told) {
        const Finished finished = couloir(arguments);
        EXPECT_EQ(finished.status, 2) << finished.err;
        EXPECT_EQ(finished.out, "");
        EXPECT_EQ(std::count(finished.err.begin(), finished.err.end(), '\n'), 1) << finished.err;
        EXPECT_NE(finished.err.find(told), std::string::npos) << told << " in " << finished.err;
        EXPECT_FALSE(std::filesystem::exists(file("new.couloir")));
    }
    void edit_refused(const Arguments& change, const std::string& told) {
        Arguments arguments{"edit", first_, "--out", file("new.couloir")};
        arguments.insert(arguments.end(), change.begin(), change.end());
        refused(arguments, told);
    }

    support::TemporaryFolder folder_;
    std::string first_ = file("first.couloir");
};

TEST_F(Compared, a_recording_equals_itself) {
    const Json json = json_of({"compare", first_, first_, "--json", "--out", file("maps")});
    for (const auto& [name, value] : json["difference"].items()) EXPECT_EQ(value, 0) << name;
    EXPECT_EQ(json["deposit"]["least_m"], 0);
    EXPECT_EQ(json["deposit"]["greatest_m"], 0);
    EXPECT_EQ(json["deposit"]["more_m3"], 0);
    EXPECT_EQ(json["peak_depth"]["greatest_m"], 0);
    EXPECT_EQ(json["overlap"], 1);
    EXPECT_EQ(json["same"], true);
    EXPECT_EQ(json["ticks_side_by_side"], kTicks);
    EXPECT_TRUE(json["told_differently"].empty());
    for (const char* map : {"difference.tif", "difference.png", "peak_difference.tif", "peak_difference.png"})
        EXPECT_TRUE(std::filesystem::exists(folder_.path() / "maps" / map)) << map;
    EXPECT_FALSE(std::filesystem::exists(folder_.path() / "maps" / "desync.png"));
}

TEST_F(Compared, with_one_of_its_commands_changed_says_which_and_where_they_part) {
    auto commands = some_commands();
    commands[2].command.rate *= 3;
    record(file("second.couloir"), small_scenario(), kTicks, commands);
    const Json json = json_of({"compare", first_, file("second.couloir"), "--json", "--out", file("maps")});
    ASSERT_EQ(json["told_differently"].size(), 1u);
    EXPECT_EQ(json["told_differently"][0],
              "at tick 3 the pour's rate is 10.1 in the first and 30.299999999999997 "
              "in the second");
    EXPECT_EQ(json["parted"]["tick"], 3);
    EXPECT_EQ(json["parted"]["stage"]["name"], "commands");
    EXPECT_GT(json["deposit"]["more_m3"].get<double>(), 0.1);
    EXPECT_GT(json["peak_depth"]["greatest_m"].get<double>(), 0.01);
    EXPECT_TRUE(std::filesystem::exists(folder_.path() / "maps" / "desync.png"));
    const Finished told = couloir({"compare", first_, file("second.couloir")});
    EXPECT_NE(told.out.find("they part in tick 3 (at 0.05 s)"), std::string::npos) << told.out;
}

TEST_F(Compared, before_they_part_two_recordings_are_the_same) {
    auto commands = some_commands();
    commands[3].command.depth *= 2;
    record(file("second.couloir"), small_scenario(), kTicks, commands);
    EXPECT_EQ(json_of({"compare", first_, file("second.couloir"), "--json", "--tick", "20"})["same"], true);
    EXPECT_EQ(json_of({"compare", first_, file("second.couloir"), "--json", "--tick", "21"})["same"], false);
}

TEST_F(Compared, a_tick_after_the_end_of_one_is_refused) {
    record(file("shorter.couloir"), small_scenario(), kTicks - 10, some_commands());
    EXPECT_EQ(json_of({"compare", first_, file("shorter.couloir"), "--json", "--tick", "30"})["same"], true);
    refused({"compare", first_, file("shorter.couloir"), "--tick", "31", "--out", file("maps")},
            "shorter: ends at tick 30, before 31");
    EXPECT_FALSE(std::filesystem::exists(file("maps")));
}

TEST_F(Compared, differences_are_the_second_minus_the_first_and_add_up) {
    auto commands = some_commands();
    commands[2].command.rate *= 3;
    const Named one{"first", first_, recording_of(some_commands())};
    const Named other{"second", "", recording_of(commands)};
    const auto a = played(one, Until::after(one.recording.last_tick()), {}, {}).value();
    const auto b = played(other, Until::after(other.recording.last_tick()), {}, {}).value();
    const Comparison forth = comparison_of(a, b, {}), back = comparison_of(b, a, {});
    double sum = 0;
    for (std::size_t i = 0; i < forth.deposit.size(); ++i) {
        ASSERT_EQ(forth.deposit[i], -back.deposit[i]);
        ASSERT_EQ(forth.peak_depth[i], -back.peak_depth[i]);
        sum += static_cast<double>(forth.deposit[i]) * a.session.state().grid.cell_area();
    }
    EXPECT_NEAR(forth.more - forth.less, sum, 1e-9);
    // Material that is in only one world was added, or has left the other.
    const auto &mass = a.session.state().ledger, &other_mass = b.session.state().ledger;
    const auto gained =
        (other_mass.poured - other_mass.out - other_mass.dug) - (mass.poured - mass.out - mass.dug);
    EXPECT_NEAR(sum, a.session.cubic_metres(gained), 1e-5);
}

TEST_F(Compared, on_another_grid_or_ground_they_are_refused_with_what_differs) {
    Scenario wider = small_scenario();
    wider.grid.dx *= 2;
    record(file("wider.couloir"), wider, 4, {});
    refused({"compare", first_, file("wider.couloir")},
            "first and wider are not on one ground: the grid is 12x10 squares of 2.1 m in the first and "
            "12x10 squares "
            "of 4.2 m in the second");
    Scenario higher = small_scenario();
    higher.bedrock[60] += 1;
    record(file("higher.couloir"), higher, 4, {});
    refused({"compare", first_, file("higher.couloir")}, "bedrock differs at 1 vertices");
}

TEST_F(Compared, files_that_are_damaged_or_missing_are_refused_in_a_sentence) {
    std::string bytes = read_bytes(first_);
    bytes[bytes.size() / 2] ^= 1;
    write_bytes(file("bad.couloir"), bytes);
    const std::string bad = file("bad.couloir"), out = file("new.couloir");
    refused({"compare", first_, bad}, "bad.couloir:1: damaged");
    refused({"compare", bad, first_}, "bad.couloir:1: damaged");
    refused({"edit", bad, "--tick", "0", "--delete", "--out", out}, "bad.couloir:1: damaged");
    refused({"normalise", bad, "--out", out}, "bad.couloir:1: damaged");
    refused({"compare", first_, "nothing.couloir"}, "nothing.couloir: there is no such file");
    refused({"compare", first_}, "second is required");
}

TEST_F(Compared, an_edit_moves_only_its_command) {
    const std::string out = file("new.couloir");
    const Json json = json_of({"edit", first_, "--tick", "20", "--move", "2.1,-4.2", "--out", out, "--json"});
    EXPECT_EQ(json["parted"]["tick"], 20);
    EXPECT_EQ(json["second"]["name"], "new");
    const Recording made = read_recording(out).value();
    auto expected = some_commands();
    expected[3].command.x += 2.1, expected[3].command.y -= 4.2;
    ASSERT_EQ(made.commands.size(), expected.size());
    for (std::size_t i = 0; i < expected.size(); ++i) {
        EXPECT_EQ(made.commands[i].tick, expected[i].tick);
        EXPECT_EQ(made.commands[i].command, expected[i].command) << i;
    }
    ASSERT_TRUE(made.header.parent);
    EXPECT_EQ(made.header.parent->name, "first");
    EXPECT_EQ(made.header.parent->tick, 20);
    EXPECT_NE(made.header.parent->change.find("blast"), std::string::npos) << made.header.parent->change;
    EXPECT_TRUE(made.end);
    const Finished verified = couloir({"replay", out, "--verify"});
    EXPECT_EQ(verified.status, 0);
    EXPECT_NE(verified.out.find("exact: all"), std::string::npos) << verified.out;
}

Edited edited_to(Edit edit) {
    const Recording recording = recording_of(some_commands());
    return edited(recording, edit).value();
}

TEST(Edit, moves_both_ends_of_a_line_and_sets_slopes) {
    sim::Command net, fell;
    net.kind = sim::CommandKind::kNet;
    net.x = 4, net.y = 5, net.to_x = 8, net.to_y = 9;
    net.height = 3, net.strength = 30;
    fell.kind = sim::CommandKind::kFell;
    const Recording recording = recording_of({{1, net}, {2, fell}});
    const auto moved = edited(recording, {1, {}, Edit::Move{{10, -1}}}).value().commands[0].command;
    EXPECT_EQ(moved.x, 14);
    EXPECT_EQ(moved.y, 4);
    EXPECT_EQ(moved.to_x, 18);
    EXPECT_EQ(moved.to_y, 8);
    const auto steep = edited(recording, {2, {}, Edit::Set{"slope=30:45.5,x=2"}}).value().commands[1].command;
    EXPECT_EQ(steep.least_slope, 30);
    EXPECT_EQ(steep.most_slope, 45.5);
    EXPECT_EQ(steep.x, 2);
    for (const char* wrong :
         {"slope=45:30", "slope=30", "slope=30:91", "slope=:", "slope=a:b", "slope=30:30"})
        EXPECT_FALSE(edited(recording, {2, {}, Edit::Set{wrong}})) << wrong;
    EXPECT_FALSE(edited(recording, {1, {}, Edit::Set{"slope=30:45"}}));
}

TEST(Edit, deletes_sets_moves_and_delays_one_command) {
    const auto before = some_commands();
    const auto without = edited_to({20, {}, Edit::Delete{}});
    EXPECT_EQ(without.commands.size(), before.size() - 1);
    EXPECT_EQ(without.commands.back().tick, 3);

    const auto set = edited_to({3, 2, Edit::Set{"rate=7,as=rolling,profile=disc,x=-3.5"}});
    EXPECT_EQ(set.commands[1].command, before[1].command);
    EXPECT_EQ(set.commands[2].command.rate, 7);
    EXPECT_EQ(set.commands[2].command.x, -3.5);
    EXPECT_EQ(set.commands[2].command.layer, sim::Layer::kRolling);
    EXPECT_EQ(set.commands[2].command.profile, sim::Profile::kDisc);

    const auto later = edited_to({0, {}, Edit::Delay{0.05}});
    EXPECT_EQ(later.commands[2].tick, 3);
    EXPECT_EQ(later.commands[2].command, before[0].command);  // after the commands already there
    const auto earlier = edited_to({20, {}, Edit::Delay{-0.25}});
    EXPECT_EQ(earlier.commands[3].tick, 5);
}

// Before the end, at it, and after the hour in which a run to rest would give up.
TEST_F(Compared, an_edit_runs_until_every_command_was_applied) {
    const std::string resting = file("resting.couloir"), out = file("new.couloir");
    record(resting, small_scenario(), 3000, some_commands());
    for (const auto& [original, seconds] :
         {std::pair(first_, "-0.1"), {first_, "0.5"}, {first_, "30"}, {resting, "30"}, {resting, "3600"}}) {
        const Json json =
            json_of({"edit", original, "--tick", "20", "--delay", seconds, "--out", out, "--json"});
        EXPECT_EQ(json["first"]["at_rest"], original == resting);
        const Recording made = read_recording(out).value();
        ASSERT_EQ(made.commands.size(), some_commands().size()) << seconds;
        const auto expected = 20 + std::llround(60 * std::stod(seconds));
        EXPECT_EQ(made.commands.back().tick, expected);
        EXPECT_GT(made.last_tick(), expected);
    }
}

TEST_F(Compared, an_edit_that_cannot_be_done_is_refused_in_a_sentence) {
    edit_refused({"--tick", "4", "--delete"}, "tick 4; ticks with commands: 0, 3, 20");
    edit_refused({"--tick", "3", "--delete"}, "--command: 1 dig x=");
    edit_refused({"--tick", "3", "--command", "3", "--delete"}, "2 commands in tick 3");
    edit_refused({"--tick", "20", "--set", "rate=3"}, "x, y, radius, depth");
    edit_refused({"--tick", "20", "--set", "depth"}, "'depth' is not NAME=VALUE");
    edit_refused({"--tick", "20", "--set", "depth=deep"}, "'deep' is not a number from 0 to 100 m");
    edit_refused({"--tick", "20", "--set", "depth=1000"}, "depth");
    edit_refused({"--tick", "0", "--set", "of=lower"}, "lower");
    edit_refused({"--tick", "20", "--move", "5"}, "'5' is not two numbers");
    edit_refused({"--tick", "20", "--delay", "-1"}, "before the first tick");
    edit_refused({"--tick", "20", "--delay", "3601"}, "216040");
    edit_refused({"--tick", "20", "--delay", "1e7"}, "216040");
    edit_refused({"--tick", "20"}, "is required");
    edit_refused({"--tick", "20", "--delete", "--move", "1,1"}, "");
    const std::string before = read_bytes(first_);
    refused({"edit", first_, "--tick", "20", "--delete", "--out", first_}, "first.couloir");
    EXPECT_EQ(read_bytes(first_), before);
}

TEST_F(Compared, a_paranoid_replay_does_every_tick_twice) {
    const Json json = json_of({"replay", first_, "--paranoid", "--json"});
    EXPECT_EQ(json["paranoid"]["same"], true);
    EXPECT_EQ(json["paranoid"]["ticks"], kTicks);
    const Finished told = couloir({"replay", first_, "--paranoid", "--threads", "2"});
    EXPECT_EQ(told.status, 0);
    EXPECT_NE(told.out.find("2 threads, tiles of 64x32, and 1 thread, tiles of 32x8 in reverse order"),
              std::string::npos)
        << told.out;
}

// Number of pixels that are much redder than blue, and much bluer than red.
std::pair<int, int> reds_and_blues(const render::Picture& picture) {
    int red = 0, blue = 0;
    for (std::size_t i = 0; i < picture.pixels.size(); i += 3) {
        const int difference = picture.pixels[i] - picture.pixels[i + 2];
        red += difference > 60, blue += difference < -60;
    }
    return {red, blue};
}

TEST_F(Compared, maps_are_red_where_there_is_more_and_blue_where_there_is_less) {
    const Named one{"first", first_, recording_of(some_commands())};
    const auto a = played(one, Until::after(one.recording.last_tick()), {}, {}).value();
    Comparison comparison{.a = a, .b = a};
    comparison.deposit.assign(small_scenario().grid.size(), 0);
    comparison.peak_depth = comparison.deposit;
    const auto [key_red, key_blue] = reds_and_blues(difference_map(comparison, MapOf::kDeposit));
    comparison.deposit[5 * 13 + 6] = 1;
    const auto [red, no_blue] = reds_and_blues(difference_map(comparison, MapOf::kDeposit));
    comparison.deposit[5 * 13 + 6] = -1;
    const auto [no_red, blue] = reds_and_blues(difference_map(comparison, MapOf::kDeposit));
    EXPECT_GT(red, key_red + 1000);
    EXPECT_LT(no_blue, key_blue + 50);
    EXPECT_GT(blue, key_blue + 1000);
    EXPECT_LT(no_red, key_red + 50);
}

TEST(DesyncPicture, marks_the_cells_that_differ) {
    const Scenario scenario = small_scenario();
    Divergence parted;
    parted.cells.assign(scenario.grid.size(), 0);
    const int before = reds_and_blues(desync_picture(parted, scenario, {"one", "other"})).first;
    parted.cells[5 * 13 + 6] = 1;
    EXPECT_GT(reds_and_blues(desync_picture(parted, scenario, {"one", "other"})).first, before + 1000);
}

TEST(Differences, name_what_stands_before_the_start) {
    Scenario a = small_scenario(), b = a;
    a.rolling.assign(a.grid.size(), 0.f), b.rolling = a.rolling;
    EXPECT_TRUE(differences_of(a, b).empty());
    sim::Command house;
    house.kind = sim::CommandKind::kHouse;
    house.x = 10, house.y = 10;
    house.length = house.width = house.height = house.strength = 5;
    a.standing.placed = {house};
    house.turn = 30;
    b.standing.placed = {house};
    b.standing.earth_budget = 500;
    b.standing.forest.resize(b.grid.size());
    b.standing.forest[5] = {400, 0, 30, 22};
    b.standing.water.assign(b.grid.size(), 0.5f);
    const auto found = differences_of(a, b);
    ASSERT_EQ(found.size(), 4u);
    EXPECT_EQ(found[0], "the forest differs at 1 vertices");
    EXPECT_EQ(found[1], "the budget of earth is without limit in the first and 500 m3 in the second");
    EXPECT_EQ(found[2], fmt::format("the water differs at {} vertices", a.grid.size()));
    EXPECT_NE(found[3].find("the house's turn is 0 in the first and 30 in the second"), std::string::npos)
        << found[3];
    b.standing = {};
    ASSERT_EQ(differences_of(a, b).size(), 1u);
    EXPECT_NE(differences_of(a, b)[0].find("only the first has"), std::string::npos);
}

}  // namespace
}  // namespace game::test
