#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <utility>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "game/ensemble/ensemble.h"
#include "game/ensemble/results.h"
#include "game/files/text_file.h"
#include "tests/support/places.h"

namespace game::test {

// A few short runs of the landslide on a coarse grid, in a folder of their own.
class SmallEnsemble : public testing::Test {
  protected:
    static constexpr const char* kSpec =
        "scene = \"landslide\"\ngrid = 20\nseconds = 30\nmembers = {}\n"
        "[[variable]]\nof = \"friction\"\nuniform = [0.1, 0.4]\n"
        "[[variable]]\nof = \"drag\"\nlist = [200, 1000]\n"
        "[[map]]\nof = \"thickness\"\nover = [0.1, 1]\n"
        "[[map]]\nof = \"speed\"\npercentiles = [90]\n"
        "[[map]]\nof = \"arrival\"\npercentiles = [50]\n";

    std::filesystem::path spec_file(int members) {
        const std::filesystem::path file = folder_.path() / "spec.toml";
        EXPECT_TRUE(write_text(file, fmt::format(fmt::runtime(kSpec), members)));
        return file;
    }
    EnsembleSpec spec(int members = 8) {
        auto read = read_ensemble_spec(spec_file(members), {});
        EXPECT_TRUE(read);
        return std::move(*read);
    }
    std::filesystem::path at(const std::string& name) const { return folder_.path() / name; }
    // All files of a folder but the journal, by name.
    std::map<std::string, std::string> files_in(const std::string& name) const {
        std::map<std::string, std::string> files;
        for (const auto& entry : std::filesystem::directory_iterator(at(name)))
            if (entry.path().filename() != kJournalName)
                files[entry.path().filename().string()] = read_text(entry.path()).value();
        return files;
    }
    // Runs it, and returns these files.
    std::map<std::string, std::string> results(const EnsembleSpec& of, const std::string& name, int threads,
                                               Ranks* ranks = nullptr) {
        const auto result = run_ensemble(of, at(name), threads, ranks);
        EXPECT_TRUE(result) << result.error().sentence;
        if (!result) return {};
        EXPECT_TRUE(write_results(at(name), of, *result));
        return files_in(name);
    }
    // All that results are made of: members and counts. Costs no maps, which take longest.
    std::pair<std::map<std::int64_t, Member>, std::string> played(const EnsembleSpec& of,
                                                                  const std::string& name, int threads,
                                                                  Ranks* ranks = nullptr) {
        auto result = run_ensemble(of, at(name), threads, ranks);
        EXPECT_TRUE(result) << result.error().sentence;
        if (!result) return {};
        return {std::move(result->members), result->counts.bytes(of.identity)};
    }
    std::string journal(const std::string& name) { return read_text(at(name) / kJournalName).value(); }

    support::TemporaryFolder folder_;
};

}  // namespace game::test
