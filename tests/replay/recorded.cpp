// The shipped recordings, played, verified, scored and recorded again with the parts that build on every processor:
// no window, no images, no GDAL. Prints the final hash, to compare with another processor's.
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "game/analysis/score.h"
#include "game/recording/recording_file.h"
#include "game/session/session.h"
#include "game/session/verifier.h"
#include "tests/support/places.h"

namespace game {
namespace {

struct Played {
    Verdict verdict;
    std::uint64_t hash;  // of the state at the end
};

void expect_done(const Outcome<void>& outcome) {
    if (!outcome) throw std::runtime_error(outcome.error().sentence);
}

// Plays the whole recording; `look` is called at the start and after each tick.
template <class Look>
void play(Session& session, const Recording& recording, Look&& look) {
    look();
    std::vector<sim::Command> due;
    while (session.state().tick < recording.last_tick()) {
        due.clear();
        for (const TimedCommand& each : commands_at(recording.commands, session.state().tick))
            due.push_back(each.command);
        expect_done(session.advance(due));
        look();
    }
}

// Plays the whole recording into the file `again`.
Played play_into(const std::filesystem::path& again, const Recording& recording,
                 const sim::StepOptions& options) {
    auto session = Session::begin(recording.header.scenario, options,
                                  record_into(again, recording.header.scenario).value())
                       .value();
    Verifier verifier(recording);
    play(session, recording, [&] { verifier.look_at(session); });
    expect_done(session.finish());
    return {verifier.verdict(), session.state_line().hash};
}

class Recorded : public testing::TestWithParam<const char*> {
  protected:
    void expect_the_same(const sim::StepOptions& options) const {
        const std::string name = GetParam();
        const auto recording =
            read_recording(support::source_dir() / "assets" / "recordings" / (name + ".couloir")).value();
        const support::TemporaryFolder folder;
        const auto again = folder.path() / "again.couloir";
        const auto [verdict, hash] = play_into(again, recording, options);
        EXPECT_TRUE(verdict.comparable);
        EXPECT_EQ(verdict.parted.value_or(""), "");
        EXPECT_EQ(verdict.compared, static_cast<std::size_t>(recording.last_tick()) + 1);
        EXPECT_EQ(verdict.proven_tick, recording.last_tick());
        EXPECT_EQ(read_recording(again).value().states, recording.states);
        const auto kernel = options.plain ? "plain" : sim::to_string(options.instruction_set);
        std::printf("%s %.*s %s\n", name.c_str(), static_cast<int>(kernel.size()), kernel.data(),
                    hex(hash).c_str());
    }
};

TEST_P(Recorded, again_is_the_same_by_the_kernels_of_this_processor) {
    for (const auto set : sim::kInstructionSets)
        if (sim::has(set)) expect_the_same({.instruction_set = set});
}

TEST_P(Recorded, again_is_the_same_by_the_plain_kernel) {
    expect_the_same({.plain = true});
}

INSTANTIATE_TEST_SUITE_P(Recordings, Recorded,
                         testing::Values("landslide", "landslide-bcre", "snow-avalanche", "winter-avalanche"),
                         [](const auto& name) {
                             std::string text = name.param;
                             std::replace(text.begin(), text.end(), '-', '_');
                             return text;
                         });

// A hut, a forest, a pit and a road: loads, lengths and volumes come from other code each.
TEST(Challenge, scores_what_its_recording_claims_on_every_processor) {
    for (const char* name :
         {"hut-on-the-rib_won", "plant-the-forest_won", "quarry_won", "open-at-five_won"}) {
        const auto recording =
            read_recording(support::source_dir() / "tests" / "challenges" / (std::string(name) + ".couloir"))
                .value();
        const Scenario& scenario = recording.header.scenario;
        Session session = Session::begin(scenario, {}, std::nullopt).value();
        Referee referee(scenario, recording.commands);
        play(session, recording, [&] { referee.see(session); });
        const auto score = referee.decide();
        ASSERT_TRUE(score) << name << ": " << score.error().sentence;
        ASSERT_TRUE(recording.claim) << name;
        EXPECT_EQ(score->claim(), *recording.claim) << name;
        const Measures& m = score->measures;
        std::printf("%s %lld; %.17g m, %.17g m, %.17g deg, %.17g m/s\n", name,
                    static_cast<long long>(score->points), m.run_out, m.peak_thickness, m.reach_deg,
                    m.peak_speed_slope);
    }
}

}  // namespace
}  // namespace game
