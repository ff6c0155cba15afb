// Every challenge that ships can be won and lost: a recording of each beside this file proves it.

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "game/analysis/measures.h"
#include "game/analysis/score.h"
#include "game/files/assets.h"
#include "game/recording/recording_file.h"
#include "game/scene/scene.h"
#include "game/session/session.h"
#include "tests/challenges/shipped.h"
#include "tests/support/places.h"

namespace game::test {
namespace {

namespace fs = std::filesystem;

std::vector<std::string> scenes_with_a_goal() {
    const std::vector<std::string> scenes = asset_names(AssetKind::kScene).value();
    std::vector<std::string> names;
    for (const std::string& name : scenes)
        if (load_scene(name, {}).value().scenario.goal) names.push_back(name);
    return names;
}

}  // namespace

const std::vector<std::string>& challenges() {
    static const std::vector<std::string> names = scenes_with_a_goal();
    return names;
}

namespace {

fs::path recording_of(const std::string& challenge, const std::string& end) {
    return support::source_dir() / "tests/challenges" / (challenge + "_" + end + ".couloir");
}

// Plays until the try ends, and judges it. Calls `see(session)` after every tick.
template <class See>
Outcome<Score> judged(const Scenario& scenario, const std::vector<TimedCommand>& commands, See&& see) {
    constexpr std::int64_t kLongest = 36'000;  // ticks
    Session session = Session::begin(scenario, {}, std::nullopt).value();
    Referee referee(scenario, commands);
    while (!session.try_ended_at() && session.state().tick < kLongest) {
        std::vector<sim::Command> now;
        for (const TimedCommand& each : commands_at(commands, session.state().tick))
            now.push_back(each.command);
        if (auto advanced = session.advance(now); !advanced) return tl::unexpected(advanced.error());
        referee.see(session);
        see(session);
    }
    return referee.decide();
}

Outcome<Score> judged(const Scenario& scenario, const std::vector<TimedCommand>& commands) {
    return judged(scenario, commands, [](const Session&) {});
}

// Finds when there is nothing more to wait for: until then something is done, the flow runs out farther by half a cell
// in five seconds or covers a hundredth more ground, or the load on a house grows.
class FrontWatch {
  public:
    explicit FrontWatch(const Recording& recording)
        : scenario_(recording.header.scenario),
          released_(release_area(scenario_, recording.commands)),
          stopped_at_(static_cast<double>(recording.commands.back().tick) / kTicks +
                      scenario_.goal->earliest_s) {}

    void see(const Session& session) {
        if (session.state().tick % kTicks != 0) return;
        flows_.push_back(measure(scenario_, session, released_, {}));
        std::int64_t load = 0;
        if (session.state().things)
            for (const sim::Thing& thing : session.state().things->list) load = std::max(load, thing.load);
        const Measures &now = flows_.back(),
                       &before = flows_[flows_.size() - std::min<std::size_t>(flows_.size(), 6)];
        if (now.run_out > before.run_out + 0.5 * static_cast<double>(scenario_.grid.dx) ||
            now.extent_area > 1.01 * before.extent_area || load > load_)
            stopped_at_ = std::max(stopped_at_, session.seconds());
        load_ = load;
    }
    double stopped_at() const { return stopped_at_; }  // s

  private:
    static constexpr std::int64_t kTicks = 60;  // in a second
    const Scenario& scenario_;
    std::vector<std::uint8_t> released_;
    std::vector<Measures> flows_;  // one a second
    std::int64_t load_ = 0;        // Pa
    double stopped_at_;
};

TEST(Challenges, each_have_a_recording_that_wins_and_one_that_loses_and_no_other_recording_is_here) {
    std::set<fs::path> wanted;
    for (const std::string& name : challenges())
        for (const char* end : {"won", "lost"}) wanted.insert(recording_of(name, end));
    ASSERT_FALSE(wanted.empty());
    std::set<fs::path> found;
    for (const auto& entry : fs::directory_iterator(support::source_dir() / "tests/challenges")) {
        if (entry.path().extension() != ".couloir") continue;
        found.insert(entry.path());
        EXPECT_LT(entry.file_size(), 400'000u) << entry.path();
    }
    EXPECT_EQ(found, wanted);
}

TEST(Challenges, are_scored_from_their_recordings_as_these_claim_soon_after_the_front_has_stopped) {
    constexpr double kSoon = 10;  // s
    for (const std::string& name : challenges())
        for (const std::string end : {"won", "lost"}) {
            const auto recording = read_recording(recording_of(name, end));
            ASSERT_TRUE(recording) << recording.error().sentence;
            EXPECT_TRUE(is_same_challenge(recording->header.scenario, load_scene(name, {}).value().scenario))
                << name;
            FrontWatch front(*recording);
            const auto score = judged(recording->header.scenario, recording->commands,
                                      [&](const Session& session) { front.see(session); });
            ASSERT_TRUE(score) << name << " " << end << ": " << score.error().sentence;
            EXPECT_EQ(score->won(), end == "won") << name;
            EXPECT_EQ(score->medal > 0, end == "won") << name;
            ASSERT_TRUE(recording->claim) << name;
            EXPECT_EQ(score->claim(), *recording->claim) << name;
            EXPECT_LE(static_cast<double>(score->tick) / 60, front.stopped_at() + kSoon)
                << name << " " << end;
        }
}

TEST(Challenges, are_not_won_by_doing_nothing) {
    for (const std::string& name : challenges()) {
        const Scene scene = load_scene(name, {}).value();
        if (scene.commands.empty()) continue;  // such a try does not end
        const auto score = judged(scene.scenario, scene.commands);
        ASSERT_TRUE(score) << name << ": " << score.error().sentence;
        EXPECT_FALSE(score->won()) << name;
    }
}

TEST(Challenges, refuse_a_recording_whose_command_was_edited) {
    for (const std::string& name : challenges()) {
        const auto recording = read_recording(recording_of(name, "lost"));
        ASSERT_TRUE(recording) << recording.error().sentence;
        const Goal& goal = *recording->header.scenario.goal;
        std::vector<TimedCommand> commands = recording->commands;
        const auto by_hand = std::ranges::find_if(commands, [&](const TimedCommand& each) {
            return std::ranges::find(goal.events, each) == goal.events.end();
        });
        ASSERT_NE(by_hand, commands.end()) << name;
        by_hand->command.radius *= 3;
        const auto score = Referee(recording->header.scenario, commands).decide();
        ASSERT_FALSE(score) << name;
        EXPECT_EQ(score.error().status, Failure::kUnusable) << name;
    }
}

}  // namespace
}  // namespace game::test
