// What the fuzzer found worth keeping: each file is a kind of recording, whole or damaged.
#include <filesystem>

#include <gtest/gtest.h>

#include "tests/fuzz/try_recording.h"
#include "tests/game/program.h"
#include "tests/support/places.h"

namespace game::test {
namespace {

TEST(RecordingCorpus, is_understood_or_refused_in_one_sentence_file_by_file) {
    int files = 0;
    for (const auto& entry :
         std::filesystem::directory_iterator(support::source_dir() / "tests/fuzz/corpus")) {
        const std::string_view fault = fault_of_reading(read_bytes(entry.path()));
        EXPECT_TRUE(fault.empty()) << entry.path() << ": " << fault;
        ++files;
    }
    EXPECT_GT(files, 20);
}

}  // namespace
}  // namespace game::test
