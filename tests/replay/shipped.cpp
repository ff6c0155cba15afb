// The shipped recordings pin the physics: the same commands give the same
// bits, with every compiler and thread count. A change of their hashes is
// a commit of its own that gives the reason, and a new physics version.
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "sim/world/ledger.h"
#include "tests/replay/play.h"

namespace game::test {
namespace {

struct Golden {
    const char* recording;
    const char* hash;  // of the final state, on the recorded grid
};

constexpr Golden kGoldens[] = {
    {"couloir-avalanche", "7c830450d08238c2"}, {"hillside", "d4495f3a8b5c427e"},
    {"landslide", "30e3f09a0a0cd7f2"},         {"landslide-bcre", "d941fb9cf4d1fed0"},
    {"snow-avalanche", "2dfe0f955228b5df"},    {"winter-avalanche", "e440189c0539f404"},
};

// Plays a recording again and returns its current state lines, one for each recorded line. After the end,
// each hash must match the state.
std::vector<StateLine> replayed(const Recording& recording, int threads, std::int64_t ticks) {
    std::vector<StateLine> lines;
    play(recording, threads, ticks, [&](const Session& now) {
        if (now.state().tick > recording.last_tick()) {
            ASSERT_EQ(now.state_line().hash, sim::state_hash(now.state())) << "tick " << now.state().tick;
        }
        if (lines.size() < recording.states.size() && recording.states[lines.size()].tick == now.state().tick)
            lines.push_back(now.state_line());
    });
    return lines;
}

class Shipped : public testing::TestWithParam<Golden> {};

TEST_P(Shipped, recording_replays_bit_for_bit_with_one_thread_and_with_two_and_rests_after_its_end) {
    const Recording recording = open(GetParam().recording);
    ASSERT_TRUE(is_comparable(recording.header));
    for (const int threads : {1, 2}) {
        const auto lines = replayed(recording, threads, recording.last_tick() + 350);
        ASSERT_EQ(lines.size(), recording.states.size());
        for (std::size_t i = 0; i < lines.size(); ++i) {
            StateLine line = lines[i];
            EXPECT_EQ(line.ledger.mass_error(), 0);
            line.ledger.initial = 0;  // is not recorded
            ASSERT_EQ(line, recording.states[i]) << "with " << threads << " threads they part at tick "
                                                 << line.tick << ", hash " << hex(line.hash);
        }
    }
}

TEST_P(Shipped, recording_is_whole_ends_at_rest_and_accounts_for_its_mass) {
    const Recording recording = open(GetParam().recording);
    EXPECT_FALSE(recording.warning);
    ASSERT_TRUE(recording.end);
    ASSERT_GE(recording.states.size(), 2u);
    EXPECT_FALSE(recording.commands.empty());
    EXPECT_EQ(recording.states.front().tick, 0);
    EXPECT_EQ(recording.states.back().tick, *recording.end);
    EXPECT_EQ(recording.states.back().ledger.rolling, 0);
    const std::int64_t initial = recording.states.front().ledger.mass_error();
    EXPECT_GT(initial, 0);
    for (std::size_t i = 1; i < recording.states.size(); ++i) {
        const StateLine& line = recording.states[i];
        EXPECT_EQ(line.ledger.mass_error(), initial) << "tick " << line.tick;
        EXPECT_LE(line.tick - recording.states[i - 1].tick, 60);
    }
}

TEST_P(Shipped, recording_ends_in_the_golden_state) {
    const Recording recording = open(GetParam().recording);
    ASSERT_FALSE(recording.states.empty());
    EXPECT_EQ(hex(recording.states.back().hash), GetParam().hash);
}

// A pour changes by a millionth of its rate, a blast by a quantum of its depth.
TEST_P(Shipped, recording_with_one_number_changed_by_the_least_ends_elsewhere) {
    Recording recording = open(GetParam().recording);
    ASSERT_FALSE(recording.commands.empty());
    sim::Command& first = recording.commands.front().command;
    if (first.kind == sim::CommandKind::kBlast)
        first.depth -= sim::kQuantum;
    else
        first.rate *= 1 + 1e-6;
    const auto lines = replayed(recording, 1, recording.last_tick());
    ASSERT_EQ(lines.size(), recording.states.size());
    EXPECT_NE(lines.back().hash, recording.states.back().hash);
}

class ShippedPours : public testing::TestWithParam<const char*> {};

TEST_P(ShippedPours, part_while_they_run_if_one_bit_of_their_rate_is_changed) {
    Recording recording = open(GetParam());
    const auto command =
        std::find_if(recording.commands.begin(), recording.commands.end(), [](const TimedCommand& each) {
            return each.command.kind != sim::CommandKind::kBlast && each.command.duration >= 0.2;
        });
    ASSERT_NE(command, recording.commands.end());
    command->command.rate = std::nextafter(command->command.rate, 1e30);
    const auto lines = replayed(recording, 1, command->tick + 2 * kTicksPerState);
    EXPECT_FALSE(
        std::equal(lines.begin(), lines.end(), recording.states.begin(),
                   [](const StateLine& now, const StateLine& then) { return now.hash == then.hash; }));
}

INSTANTIATE_TEST_SUITE_P(Recordings, ShippedPours, testing::Values("landslide", "landslide-bcre"),
                         [](const auto& recording) {
                             std::string name = recording.param;
                             std::replace(name.begin(), name.end(), '-', '_');
                             return name;
                         });

INSTANTIATE_TEST_SUITE_P(Recordings, Shipped, testing::ValuesIn(kGoldens), [](const auto& golden) {
    std::string name = golden.param.recording;
    std::replace(name.begin(), name.end(), '-', '_');
    return name;
});

TEST(ShippedRecordings, are_those_that_have_a_golden_state) {
    std::vector<std::string> known;
    for (const Golden& golden : kGoldens) known.emplace_back(golden.recording);
    EXPECT_EQ(asset_names(AssetKind::kRecording).value(), known);
}

}  // namespace
}  // namespace game::test
