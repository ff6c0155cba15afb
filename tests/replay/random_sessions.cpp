// Random user actions on a world: the recording must replay bit for bit, whatever they are.
#include "tests/replay/random_session.h"

#include <algorithm>
#include <atomic>
#include <cstdio>
#include <cstdlib>
#include <mutex>
#include <thread>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "tests/replay/environment.h"
#include "tests/support/places.h"

namespace game::test {
namespace {

constexpr int kMostShrinking = 200;  // sessions played to shorten a failing one

std::optional<std::string> fault_in_folder(const RandomSession& session, Tally& tally) {
    const support::TemporaryFolder folder;
    return fault_of(session, folder.path(), tally);
}

// The shortest session found that still fails, and its fault.
std::string report_of(const RandomSession& failing) {
    int tries = 0;
    Tally ignored;
    const RandomSession shortest = shrunk(failing, [&](const RandomSession& each) {
        return ++tries <= kMostShrinking && fault_in_folder(each, ignored);
    });
    return to_text(shortest) + "  " + fault_in_folder(shortest, ignored).value_or("(no longer fails)");
}

// Plays seeds from `first` on, with this many workers at once. Returns the failures.
std::vector<std::string> play_sessions(std::uint64_t first, int count, unsigned workers) {
    std::atomic<int> next = 0;
    std::mutex mutex;
    Tally tally;
    std::vector<std::string> failures;
    const auto work = [&] {
        for (int i = next++; i < count; i = next++) {
            const RandomSession session = random_session(first + static_cast<std::uint64_t>(i));
            Tally own;
            const auto fault = fault_in_folder(session, own);
            const std::string report = fault ? report_of(session) : "";
            const std::scoped_lock lock(mutex);
            tally.add(own);
            if (fault) failures.push_back(report);
        }
    };
    std::vector<std::thread> threads;
    for (unsigned i = 0; i < workers; ++i) threads.emplace_back(work);
    for (std::thread& thread : threads) thread.join();
    std::printf(
        "%d sessions, %lld ticks compared, %lld recordings, %lld replays of %lld states: %zu differ\n", count,
        static_cast<long long>(tally.ticks), static_cast<long long>(tally.files),
        static_cast<long long>(tally.replays.count), static_cast<long long>(tally.replays.states),
        failures.size());
    return failures;
}

void expect_none(const std::vector<std::string>& failures) {
    for (const std::string& failure : failures) ADD_FAILURE() << failure;
}

TEST(RandomSessions, of_which_there_are_20_replay_bit_for_bit) {
    expect_none(play_sessions(1, 20, 1));
}

// COULOIR_SESSIONS=N plays N sessions, COULOIR_SEED=S starts with seed S.
TEST(RandomSessions, of_which_there_are_1000_replay_bit_for_bit) {
    if (!std::getenv("COULOIR_LONG") && !std::getenv("COULOIR_SESSIONS"))
        GTEST_SKIP() << "runs with COULOIR_LONG=1: ctest -L long";
    expect_none(play_sessions(number_of("COULOIR_SEED", 1000),
                              static_cast<int>(number_of("COULOIR_SESSIONS", 1000)),
                              std::max(1u, std::thread::hardware_concurrency())));
}

TEST(RandomSessions, are_the_same_for_the_same_seed_and_cover_every_act_and_command) {
    std::vector<int> acts(7), commands(std::size(sim::kCommands));
    for (std::uint64_t seed = 1; seed <= 150; ++seed) {
        const RandomSession session = random_session(seed);
        EXPECT_EQ(to_text(session), to_text(random_session(seed)));
        for (const Act& act : session.acts) {
            ++acts.at(act.kind);
            if (act.kind != Act::kHand) continue;
            ++commands.at(static_cast<std::size_t>(act.command.kind));
            EXPECT_FALSE(sim::fault_of(act.command, session.scenario.lower.has_value()));
        }
    }
    EXPECT_GT(*std::min_element(acts.begin(), acts.end()), 10);
    EXPECT_GT(*std::min_element(commands.begin(), commands.end()), 10);
}

TEST(RandomSessions, are_shrunk_to_the_acts_that_fail) {
    // Fails if a dig comes after a branch and 20 ticks pass then.
    const auto fails = [](const RandomSession& session) {
        bool branched = false, dug = false;
        for (const Act& act : session.acts) {
            if (act.kind == Act::kBranch) branched = true;
            if (act.kind == Act::kHand && act.command.kind == sim::CommandKind::kDig) dug = branched;
            if (act.kind == Act::kTicks && act.ticks >= 20 && dug) return true;
        }
        return false;
    };
    int found = 0;
    for (std::uint64_t seed = 1; seed <= 300; ++seed) {
        const RandomSession session = random_session(seed);
        if (!fails(session)) continue;
        ++found;
        const RandomSession shortest = shrunk(session, fails);
        ASSERT_EQ(shortest.acts.size(), 3u) << to_text(shortest);
        EXPECT_EQ(shortest.acts[0].kind, Act::kBranch);
        EXPECT_LT(shortest.acts[2].ticks, 40);
    }
    EXPECT_GT(found, 3);
}

}  // namespace
}  // namespace game::test
