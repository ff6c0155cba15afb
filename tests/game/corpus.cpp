// The fuzzer's corpus: each file is a distinct kind of recording, whole or damaged.
#include <filesystem>
#include <sstream>

#include <gtest/gtest.h>

#include "game/recording/recording_file.h"
#include "tests/fuzz/try_recording.h"
#include "tests/game/program.h"
#include "tests/support/places.h"

namespace game::test {
namespace {

// Calls try_file(path, bytes) for each file of a folder and returns their number.
template <class TryFile>
int for_each_file(const std::filesystem::path& folder, const TryFile& try_file) {
    int files = 0;
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
        try_file(entry.path(), read_bytes(entry.path()));
        ++files;
    }
    return files;
}

void expect_no_fault(const std::filesystem::path& path, const std::string& bytes) {
    const std::string_view fault = fault_of_reading(bytes);
    EXPECT_TRUE(fault.empty()) << path << ": " << fault;
}

int expect_regressions(const char* outcome, bool accepted) {
    const auto folder = support::source_dir() / "tests/fuzz/regressions" / outcome;
    return for_each_file(folder, [&](const std::filesystem::path& path, const std::string& bytes) {
        expect_no_fault(path, bytes);
        std::istringstream stream(bytes);
        EXPECT_EQ(read_recording(stream, "x.couloir").has_value(), accepted) << path;
    });
}

TEST(RecordingCorpus, is_understood_or_refused_in_one_sentence_file_by_file) {
    EXPECT_GT(for_each_file(COULOIR_RECORDING_CORPUS, expect_no_fault), 400);
}

TEST(RecordingRegressions, are_refused_or_accepted_as_their_folder_says) {
    EXPECT_GT(expect_regressions("refused", false), 20);
    EXPECT_GT(expect_regressions("accepted", true), 0);
}

}  // namespace
}  // namespace game::test
