// Every reader of untrusted files, with files that are whole, truncated, or changed in a few bytes; libFuzzer
// does the same for longer (tests/fuzz).
#include <algorithm>
#include <random>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "game/files/assets.h"
#include "tests/fuzz/try_reader.h"
#include "tests/game/program.h"
#include "tests/support/places.h"

namespace game::test {
namespace {

std::vector<std::string> shipped(AssetKind kind) {
    std::vector<std::string> all;
    const auto names = asset_names(kind).value();
    for (const std::string& name : names) all.push_back(read_bytes(find_asset(kind, name).value()));
    return all;
}

// In a folder that may be missing.
std::vector<std::filesystem::path> files_in(const std::filesystem::path& folder) {
    std::vector<std::filesystem::path> files;
    std::error_code error;
    for (const auto& entry : std::filesystem::directory_iterator(folder, error))
        files.push_back(entry.path());
    std::sort(files.begin(), files.end());
    return files;
}

// Whole files of this reader's kind, by name.
std::vector<std::string> seeds(const TriedReader& reader) {
    if (reader.name == "scene") return shipped(AssetKind::kScene);
    if (reader.name == "material") return shipped(AssetKind::kMaterial);
    if (reader.name == "lesson") return shipped(AssetKind::kLesson);
    std::vector<std::string> all;
    for (const auto& file : files_in(support::source_dir() / "tests/fuzz/seeds" / reader.name))
        all.push_back(read_bytes(file));
    return all;
}

class EveryReader : public testing::TestWithParam<TriedReader> {
  protected:
    void expect_sound(std::string_view bytes, const std::string& options) const {
        const std::string fault = fault_of_reading(GetParam(), folder_.path(), bytes);
        EXPECT_EQ(fault, "") << options;
    }
    support::TemporaryFolder folder_;
};

TEST_P(EveryReader, accepts_whole_files) {
    const auto all = seeds(GetParam());
    ASSERT_FALSE(all.empty());
    const auto file = folder_.path() / GetParam().file_name;
    for (const std::string& bytes : all) {
        write_bytes(file, bytes);
        const auto read = GetParam().read(file);
        EXPECT_TRUE(read) << read.error().sentence;
    }
}

TEST_P(EveryReader, accepts_or_refuses_in_one_line_files_found_by_fuzzing) {
    testing::internal::CaptureStderr();  // the libraries must not print anything themselves
    for (const auto& file : files_in(support::source_dir() / "tests/fuzz/found" / GetParam().name))
        expect_sound(read_bytes(file), file.filename().string());
    EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

TEST_P(EveryReader, accepts_or_refuses_in_one_line_truncated_files) {
    const auto all = seeds(GetParam());
    // At as many places in all, however many files there are.
    const std::size_t places = std::clamp<std::size_t>(320 / all.size(), 8, 40);
    for (const std::string& bytes : all)
        for (std::size_t i = 0; i < places; ++i) {
            const std::size_t length = bytes.size() * i / places;
            expect_sound(bytes.substr(0, length), "cut off after " + std::to_string(length));
        }
}

TEST_P(EveryReader, accepts_or_refuses_in_one_line_changed_files) {
    std::mt19937 random(11);
    const auto all = seeds(GetParam());
    for (int i = 0; i < 300; ++i) {
        std::string bytes = all[random() % all.size()];
        const auto somewhere = [&] { return random() % bytes.size(); };
        for (auto changes = 1 + random() % 4; changes > 0; --changes) switch (random() % 4) {
                case 0:
                    bytes[somewhere()] = static_cast<char>(random());
                    break;
                case 1:
                    bytes[somewhere()] ^= static_cast<char>(1u << random() % 8);
                    break;
                case 2:
                    bytes.insert(somewhere(), bytes.substr(somewhere(), random() % 32));
                    break;
                default:
                    bytes.erase(somewhere(), random() % 8);
                    if (bytes.empty()) bytes.assign(1, 'x');
            }
        expect_sound(bytes, fmt::format("change {}", i));
    }
}

INSTANTIATE_TEST_SUITE_P(All, EveryReader,
                         testing::Values(kTriedScene, kTriedMaterial, kTriedObj, kTriedNpy, kTriedGeojson,
                                         kTriedDem, kTriedPicture, kTriedEnsemble, kTriedJournal, kTriedLive,
                                         kTriedCameraPath, kTriedLesson, kTriedLanguage),
                         [](const auto& each) { return std::string(each.param.name); });

}  // namespace
}  // namespace game::test
