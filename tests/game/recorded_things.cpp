// Recordings of worlds in which things stand and are built.
#include <filesystem>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "game/recording/recording_file.h"
#include "tests/game/program.h"
#include "tests/game/recording_files.h"
#include "tests/support/places.h"

namespace game::test {
namespace {

sim::Command of(sim::CommandKind kind, double x, double y) {
    sim::Command command;
    command.kind = kind;
    command.x = x, command.y = y;
    return command;
}

// A slope on which a bit of everything stands, under a release.
Scenario built_up() {
    Scenario scenario = small_scenario();
    scenario.density = 1300;
    Scenario::Standing& standing = scenario.standing;
    standing.earth_budget = 500;
    standing.forest.resize(scenario.grid.size());
    for (std::size_t i = 30; i < 60; ++i) standing.forest[i] = {400, 0, 30, 22};
    sim::Command dam = of(sim::CommandKind::kSculpt, 6, 5), house = of(sim::CommandKind::kHouse, 18, 6),
                 net = of(sim::CommandKind::kNet, 10, 12), road = of(sim::CommandKind::kRoad, 8, 4);
    dam.radius = 2, dam.rise = 1.1;
    dam.profile = sim::Profile::kCone;
    house.length = 5, house.width = 4.5, house.height = 3, house.strength = 5, house.turn = 33;
    net.to_x = 16, net.to_y = 12.5, net.height = 3, net.strength = 30;
    road.to_x = 22, road.to_y = 3, road.width = 4;
    standing.placed = {dam, house, net, road};
    return scenario;
}

// What a user does to them.
std::vector<TimedCommand> deeds() {
    sim::Command plant = of(sim::CommandKind::kPlant, 20, 15), fell = of(sim::CommandKind::kFell, 4, 6),
                 turn = of(sim::CommandKind::kTurn, 18, 6), remove = of(sim::CommandKind::kRemove, 13, 12),
                 level = of(sim::CommandKind::kLevel, 22, 2), blast = of(sim::CommandKind::kBlast, 12, 18),
                 wet = of(sim::CommandKind::kWet, 12, 12), drain = of(sim::CommandKind::kDrain, 12, 10);
    plant.radius = 3, plant.stems = 700, plant.diameter = 0.2, plant.height = 12;
    plant.least_slope = 20, plant.most_slope = 60;
    fell.radius = 3;
    turn.turn = -60;
    remove.radius = 2;
    level.radius = 2, level.rise = 0.7, level.level = 1235;
    blast.radius = 4, blast.depth = 0.2;
    wet.radius = 9, wet.rate = 0.1, wet.duration = 0.3, wet.profile = sim::Profile::kCone;
    drain.radius = 4, drain.rate = 0.01, drain.duration = 0.2;
    return {{3, plant}, {3, fell}, {5, wet}, {7, turn}, {9, blast}, {14, remove}, {16, level}, {20, drain}};
}

class RecordedThings : public testing::Test {
  protected:
    RecordedThings() { record(path_, built_up(), 40, deeds()); }

    support::TemporaryFolder folder_;
    std::filesystem::path path_ = folder_.path() / "things.couloir";
};

TEST_F(RecordedThings, are_read_as_they_were_written) {
    const auto recording = read_recording(path_);
    ASSERT_TRUE(recording) << recording.error().sentence;
    EXPECT_FALSE(recording->warning) << *recording->warning;
    EXPECT_EQ(recording->header.scenario.standing, built_up().standing);
    const auto commands = deeds();
    ASSERT_EQ(recording->commands.size(), commands.size());
    for (std::size_t i = 0; i < commands.size(); ++i) {
        EXPECT_EQ(recording->commands[i].tick, commands[i].tick);
        EXPECT_EQ(recording->commands[i].command, commands[i].command);
    }
}

TEST_F(RecordedThings, replay_bit_identical_in_every_way) {
    for (const std::vector<std::string>& way :
         {std::vector<std::string>{}, {"--kernel", "plain"}, {"--threads", "3"}}) {
        std::vector<std::string> arguments{"replay", path_.string(), "--verify", "--json"};
        arguments.insert(arguments.end(), way.begin(), way.end());
        const Finished replayed = couloir(arguments);
        EXPECT_EQ(replayed.status, 0) << replayed.err << replayed.out;
        const Json summary = Json::parse(replayed.out);
        EXPECT_EQ(summary["verified"]["outcome"], "exact");
        EXPECT_EQ(summary["mass"]["error_quanta"], 0);
        EXPECT_EQ(summary["things"]["objects"].size(), 2u) << "the net was removed";
    }
}

TEST_F(RecordedThings, cut_anywhere_keep_their_whole_lines_or_name_the_header) {
    const std::string whole = read_bytes(path_);
    const std::size_t header = whole.find('\n') + 1;
    for (std::size_t length = 0; length < whole.size(); length += length < header ? 1 : 7) {
        std::istringstream stream(whole.substr(0, length));
        const auto recording = read_recording(stream, "cut.couloir");
        ASSERT_EQ(recording.has_value(), length >= header) << length;
        if (recording) {
            ASSERT_TRUE(recording->warning) << length;
        } else {
            ASSERT_EQ(recording.error().sentence.rfind("cut.couloir", 0), 0u) << recording.error().sentence;
        }
    }
}

}  // namespace
}  // namespace game::test
