#include <sys/wait.h>

#include <chrono>
#include <csignal>
#include <filesystem>
#include <string>
#include <thread>

#include <gtest/gtest.h>

#include "game/recording/recording_file.h"
#include "tests/game/program.h"
#include "tests/support/places.h"

namespace game::test {
namespace {

// Kills a running recorder once its file has this length; false if it never reaches it.
bool kill_at_size(const std::filesystem::path& path, std::uintmax_t size) {
    std::filesystem::remove(path);  // of an earlier one, which may be as long
    const pid_t child =
        start_couloir({"run", "landslide", "--grid", "40", "--seconds", "3600", "--record", path.string()});
    std::error_code error;
    bool reached = false;
    for (int wait = 0; wait < 60000 && !reached; ++wait) {
        const auto now = std::filesystem::file_size(path, error);
        reached = !error && now >= size;
        if (!reached) std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    kill(child, SIGKILL);
    int options = 0;
    waitpid(child, &options, 0);
    return reached && WIFSIGNALED(options) && WTERMSIG(options) == SIGKILL;
}

TEST(KilledRecording, opens_and_reports_the_last_verified_tick) {
    const support::TemporaryFolder folder;
    const auto path = folder.path() / "killed.couloir";
    for (const std::uintmax_t size : {20000u, 40000u, 80000u}) {
        ASSERT_TRUE(kill_at_size(path, size));
        const auto recording = read_recording(path);
        ASSERT_TRUE(recording) << recording.error().sentence;
        ASSERT_TRUE(recording->warning);
        EXPECT_FALSE(recording->end);
        ASSERT_FALSE(recording->states.empty());
        const std::int64_t proven = recording->states.back().tick;
        EXPECT_GT(proven, 0);

        const Finished replayed = couloir({"replay", path.string(), "--verify"});
        EXPECT_EQ(replayed.status, 0) << replayed.err;
        EXPECT_NE(replayed.out.find("proven up to tick " + std::to_string(proven) + "\n"), std::string::npos)
            << replayed.out;
        EXPECT_NE(replayed.err.find("warning: " + path.string()), std::string::npos) << replayed.err;
    }
}

}  // namespace
}  // namespace game::test
