// Challenges that are made of what a person did.
#include "game/analysis/made_challenge.h"

#include <cstdlib>
#include <string>

#include <gtest/gtest.h>

#include "game/app/challenge_maker.h"
#include "game/recording/recording_file.h"
#include "game/session/loaded_world.h"
#include "tests/game/program.h"
#include "tests/game/recording_files.h"
#include "tests/support/places.h"

namespace game::test {
namespace {

TimedCommand at(std::int64_t tick, sim::CommandKind kind, double x, double y) {
    TimedCommand timed{tick, {}};
    timed.command.kind = kind;
    timed.command.x = x, timed.command.y = y;
    return timed;
}

TimedCommand blast_at(std::int64_t tick, double x, double y) {
    TimedCommand blast = at(tick, sim::CommandKind::kBlast, x, y);
    blast.command.radius = 40, blast.command.depth = 2;
    return blast;
}

class MadeChallenge : public testing::Test {
  protected:
    MadeChallenge() {
        setenv("XDG_DATA_HOME", folder_.path().c_str(), 1);
        Overrides overrides;
        overrides.squares = 60;
        scenario_ = load_scene("winter-valley", overrides).value().scenario;
        scenario_.standing.placed.clear();
    }
    Outcome<Scenario> make(const History& history) {
        return make_challenge(scenario_, history, sim::StepOptions{}, file_, stop_);
    }
    bool is_left_over() const {
        return std::filesystem::exists(file_) || std::filesystem::exists(file_.string() + ".part");
    }

    support::TemporaryFolder folder_;
    std::filesystem::path file_ = folder_.path() / "own.couloir";
    std::atomic<bool> stop_ = false;
    Scenario scenario_;
};

TEST_F(MadeChallenge, is_won_by_what_was_done_and_its_file_proves_it) {
    const auto made = make({{}, {blast_at(30, 620, 1725)}});
    ASSERT_TRUE(made) << made.error().sentence;
    const Goal& goal = *made->goal;
    ASSERT_EQ(goal.tools.size(), 1u);
    EXPECT_EQ(goal.tools[0].count, 1);
    EXPECT_EQ(goal.tools[0].limits, (std::vector<Goal::Limit>{{"radius", 0, 40}, {"depth", 0, 2}}));
    EXPECT_TRUE(goal.needs.empty()) << "nothing stands there";
    const auto [bronze, silver, gold] = goal.medals;
    EXPECT_GT(gold, 100);
    EXPECT_EQ(gold % 10, 0);
    EXPECT_NEAR(static_cast<double>(silver), 0.8 * static_cast<double>(gold), 12);
    EXPECT_NEAR(static_cast<double>(bronze), 0.6 * static_cast<double>(gold), 12);
    EXPECT_EQ(goal.say, "One blast. Make it run " + std::to_string(gold) + " m.");

    const auto recording = read_recording(file_);
    ASSERT_TRUE(recording) << recording.error().sentence;
    EXPECT_FALSE(recording->warning);
    EXPECT_EQ(recording->header.scenario.goal, goal);
    EXPECT_TRUE(is_same_challenge(recording->header.scenario, *made));
    ASSERT_TRUE(recording->claim);
    EXPECT_EQ(recording->claim->medal, 3);
    EXPECT_EQ(recording->end, recording->claim->tick);
    const Finished scored = couloir({"replay", file_.string(), "--score", "--verify"});
    EXPECT_EQ(scored.status, 0) << scored.err;
    EXPECT_NE(scored.out.find("challenge: Won: gold"), std::string::npos) << scored.out;

    auto bodies = bodies_of(read_bytes(file_));
    for (std::string& body : bodies)
        if (const auto place = body.find("\"score\":");
            body.rfind("{\"tick\"", 0) == 0 && place != std::string::npos)
            body.replace(place, 8, "\"score\":9");
    write_bytes(file_, chained(bodies));
    const Finished edited = couloir({"replay", file_.string(), "--score"});
    EXPECT_EQ(edited.status, 1) << edited.out;
    EXPECT_FALSE(is_left_over() && std::filesystem::exists(file_.string() + ".part"));
}

TEST_F(MadeChallenge, opens_as_the_recording_that_wins) {
    ASSERT_TRUE(make({{}, {blast_at(0, 620, 1725)}}));
    const auto world = open_anything(file_.string(), {});
    ASSERT_TRUE(world) << world.error().sentence;
    EXPECT_TRUE(world->watched);
    EXPECT_TRUE(world->scene.scenario.goal);
}

TEST_F(MadeChallenge, has_each_tool_as_often_as_much_and_as_large_as_it_was_used) {
    std::vector<TimedCommand> done{blast_at(5, 620, 1725)};
    for (int i = 0; i < 20; ++i) {
        TimedCommand pour = at(10 + i, sim::CommandKind::kPour, 640, 1700);
        pour.command.radius = 10 + i, pour.command.rate = 600, pour.command.duration = 1.0 / 60;
        pour.command.layer = sim::Layer::kStanding;
        done.push_back(pour);
    }
    TimedCommand set = at(40, sim::CommandKind::kSet, 0, 0);
    set.command.param = sim::param_from("start_slope").value(), set.command.value = 0.9;
    done.push_back(set);
    TimedCommand house = at(50, sim::CommandKind::kHouse, 600, 300);
    house.command.length = 20, house.command.width = 10, house.command.height = 8, house.command.strength = 5;
    done.push_back(house);
    const auto goal = goal_of(scenario_, {{at(20, sim::CommandKind::kSettle, 1, 1)}, done});
    ASSERT_TRUE(goal) << goal.error().sentence;
    ASSERT_EQ(goal->tools.size(), 3u);
    const Goal::Tool* const pour = tool_of(*goal, sim::CommandKind::kPour);
    ASSERT_TRUE(pour);
    EXPECT_FALSE(pour->count);
    EXPECT_NEAR(pour->total.value(), 200, 1);
    EXPECT_GE(pour->total.value(), 20 * 600.0 / 60 * (1 - 1e-9));
    EXPECT_EQ(pour->layer, sim::Layer::kStanding);
    EXPECT_EQ(limit_of(*pour, &sim::Command::radius)->most, 29);
    EXPECT_FALSE(limit_of(*pour, &sim::Command::x));
    EXPECT_FALSE(limit_of(*pour, &sim::Command::duration));
    ASSERT_EQ(goal->events.size(), 2u) << "the scene's own, and the parameter";
    EXPECT_EQ(goal->events[1].command.kind, sim::CommandKind::kSet);
    EXPECT_EQ(goal->say, "One blast, 200 m³ to pour and one house.");
    EXPECT_FALSE(fault_of(*goal) && *fault_of(*goal) != "has medals that do not rise");

    GoalUse use(*goal);
    std::vector<TimedCommand> all = goal->events;
    for (const TimedCommand& each : done)
        if (each.command.kind != sim::CommandKind::kSet) all.push_back(each);
    std::ranges::stable_sort(all, {}, &TimedCommand::tick);
    for (const TimedCommand& each : all)
        EXPECT_FALSE(use.take(each, scenario_.params.tick_s)) << sim::info_of(each.command.kind).name;
}

TEST_F(MadeChallenge, asks_for_what_houses_and_roads_came_to) {
    TimedCommand house = at(0, sim::CommandKind::kHouse, 400, 100),
                 road = at(1, sim::CommandKind::kRoad, 300, 60);
    house.command.length = 20, house.command.width = 10, house.command.height = 8, house.command.strength = 5;
    road.command.to_x = 500, road.command.to_y = 60, road.command.width = 6;
    const auto made = make({{}, {house, road, blast_at(30, 620, 1725)}});
    ASSERT_TRUE(made) << made.error().sentence;
    const Goal& goal = *made->goal;
    ASSERT_EQ(goal.needs.size(), 2u);
    EXPECT_EQ(goal.needs[0].quantity.measure, Measure::kDestroyed);
    EXPECT_EQ(goal.needs[0].most, 0);
    EXPECT_EQ(goal.needs[1].quantity.measure, Measure::kBlocked);
    EXPECT_NE(goal.say.find("spare all houses and leave the road clear."), std::string::npos) << goal.say;
    EXPECT_EQ(couloir({"replay", file_.string(), "--score"}).status, 0);
}

// The second blast comes when the first slide is calm already.
TEST_F(MadeChallenge, waits_as_long_as_the_person_did) {
    const auto made = make({{}, {blast_at(0, 620, 1725), blast_at(6000, 660, 1700)}});
    ASSERT_TRUE(made) << made.error().sentence;
    EXPECT_EQ(made->goal->earliest_s, 101);
    EXPECT_EQ(made->goal->tools[0].count, 2);
    EXPECT_EQ(read_recording(file_)->commands.size(), 2u);
}

TEST_F(MadeChallenge, needs_something_that_was_done_and_that_ran) {
    const auto nothing = make({{}, {}});
    ASSERT_FALSE(nothing);
    EXPECT_EQ(nothing.error().status, Failure::kUnusable);
    TimedCommand small = blast_at(0, 400, 100);  // in the valley
    small.command.radius = 1, small.command.depth = 0.01;
    const auto little = make({{}, {small}});
    ASSERT_FALSE(little);
    EXPECT_NE(little.error().sentence.find("it ran"), std::string::npos) << little.error().sentence;
    EXPECT_FALSE(is_left_over());
}

TEST_F(MadeChallenge, leaves_nothing_if_it_is_stopped_or_cannot_be_written) {
    stop_ = true;
    EXPECT_EQ(make({{}, {blast_at(0, 620, 1725)}}).error().status, Failure::kMachine);
    EXPECT_FALSE(is_left_over());
    stop_ = false;
    file_ = folder_.path() / "a file" / "own.couloir";
    write_bytes(folder_.path() / "a file", "x");
    const auto made = make({{}, {blast_at(0, 620, 1725)}});
    ASSERT_FALSE(made);
    EXPECT_EQ(made.error().status, Failure::kMachine);

    ChallengeMaker maker;
    write_bytes(folder_.path() / "couloir", "a file in place of the folder");
    ASSERT_TRUE(maker.begin(scenario_, {{}, {blast_at(0, 620, 1725)}}, {}, {}));
    EXPECT_TRUE(maker.is_busy());
    std::optional<Outcome<ChallengeMaker::Made>> result;
    while (!(result = maker.result())) {
    }
    EXPECT_EQ(result->error().status, Failure::kMachine);
    EXPECT_FALSE(maker.is_busy());
}

}  // namespace
}  // namespace game::test
