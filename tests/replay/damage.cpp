// Shipped recordings, truncated and altered: the reader
// recovers the whole lines, or one sentence names the fault.
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <random>
#include <sstream>

#include <gtest/gtest.h>

#include "game/recording/recording_file.h"
#include "tests/replay/play.h"

namespace game::test {
namespace {

class DamagedShipped : public testing::Test {
  protected:
    DamagedShipped() {
        std::ifstream file(find_asset(AssetKind::kRecording, "landslide").value(), std::ios::binary);
        whole_.assign(std::istreambuf_iterator<char>(file), {});
        header_end_ = whole_.find('\n');
    }

    static Outcome<Recording> read(const std::string& bytes) {
        std::istringstream stream(bytes);
        return read_recording(stream, "it");
    }

    void expect_cut(std::size_t length) const {
        const std::string cut = whole_.substr(0, length);
        const auto recording = read(cut);
        if (length <= header_end_) {
            ASSERT_FALSE(recording);
            const std::string where = length == 0 ? "it: empty" : "it:1: ";
            EXPECT_EQ(recording.error().sentence.rfind(where, 0), 0u) << recording.error().sentence;
            EXPECT_EQ(recording.error().status, Failure::kUnusable);
            return;
        }
        ASSERT_TRUE(recording) << recording.error().sentence;
        const auto lines = static_cast<std::size_t>(std::count(cut.begin(), cut.end(), '\n'));
        EXPECT_EQ(1 + recording->commands.size() + recording->states.size() + (recording->end ? 1 : 0),
                  lines);
        EXPECT_EQ(recording->warning.has_value(), length < whole_.size());
        if (cut.back() == '\n' || length == whole_.size()) return;
        const std::string lost = "bytes " + std::to_string(cut.rfind('\n') + 1) + " to " +
                                 std::to_string(length - 1) + " are lost";
        EXPECT_NE(recording->warning->find(lost), std::string::npos) << *recording->warning;
    }

    std::string whole_;
    std::size_t header_end_ = 0;
};

TEST_F(DamagedShipped, cut_at_every_byte_of_its_last_kilobyte_keeps_its_whole_lines) {
    for (std::size_t length = whole_.size() - 1024; length <= whole_.size(); ++length) {
        SCOPED_TRACE(length);
        expect_cut(length);
    }
}

TEST_F(DamagedShipped, cut_at_a_thousand_places_keeps_its_whole_lines) {
    std::mt19937 random(1);
    for (int i = 0; i < 1000; ++i) {
        const std::size_t length = random() % whole_.size();
        SCOPED_TRACE(length);
        expect_cut(length);
    }
}

TEST_F(DamagedShipped, with_any_of_a_thousand_bytes_altered_names_line_and_fact) {
    std::mt19937 random(2);
    for (int i = 0; i < 1000; ++i) {
        const std::size_t at = random() % (whole_.size() - 1);
        std::string altered = whole_;
        altered[at] = static_cast<char>(static_cast<unsigned char>(altered[at]) ^ (1 + random() % 255));
        const auto recording = read(altered);
        ASSERT_FALSE(recording) << "byte " << at;
        const auto line =
            1 + std::count(whole_.begin(), whole_.begin() + static_cast<std::ptrdiff_t>(at), '\n');
        const std::string& sentence = recording.error().sentence;
        EXPECT_EQ(sentence.rfind("it:" + std::to_string(line) + ": ", 0), 0u) << sentence;
        EXPECT_EQ(sentence.find('\n'), std::string::npos) << sentence;
    }
}

}  // namespace
}  // namespace game::test
