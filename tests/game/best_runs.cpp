// The best runs of a challenge are kept, each once, and nothing else in their folder is touched.

#include "game/analysis/best_runs.h"

#include <cstdlib>
#include <fstream>
#include <thread>

#include <gtest/gtest.h>

#include "game/app/result_card.h"
#include "game/files/text_file.h"
#include "game/scene/scene.h"
#include "game/session/run_extent.h"
#include "tests/support/places.h"
#include "tests/support/worlds.h"

namespace game::test {
namespace {

namespace fs = std::filesystem;

Score score_of(std::int64_t points, int medal) {
    Score score;
    score.points = points, score.medal = medal;
    return score;
}

class BestRuns : public testing::Test {
  protected:
    BestRuns() { setenv("XDG_DATA_HOME", folder_.path().c_str(), 1); }

    void keep(std::int64_t points, int medal, std::uint64_t hash) {
        const auto kept = keep_run(best(), score_of(points, medal), hash, "a recording");
        ASSERT_TRUE(kept) << kept.error().sentence;
    }
    std::vector<std::int64_t> scores() const {
        std::vector<std::int64_t> scores;
        for (const BestRun& run : best_runs(best())) scores.push_back(run.score);
        return scores;
    }
    std::size_t files() const {
        return static_cast<std::size_t>(
            std::distance(fs::directory_iterator(best()), fs::directory_iterator()));
    }
    void put(const char* name) const { std::ofstream(best() / name) << "as it is"; }
    fs::path best() const { return folder_.path() / "best"; }

    support::TemporaryFolder folder_;
};

TEST_F(BestRuns, are_none_at_first) {
    EXPECT_TRUE(best_runs(best()).empty());
}

TEST_F(BestRuns, are_sorted_by_medal_and_then_by_score) {
    keep(30, 0, 1);
    keep(-5, 1, 2);
    keep(20, 3, 3);
    keep(21, 3, 4);
    EXPECT_EQ(scores(), (std::vector<std::int64_t>{21, 20, -5, 30}));
    const BestRun first = best_runs(best()).front();
    EXPECT_EQ(first.medal, 3);
    EXPECT_EQ(first.hash, 4u);
    EXPECT_EQ(first.when.size(), std::string("2026-11-26 12:58:00").size());
    EXPECT_EQ(first.when[13], ':');
    EXPECT_EQ(read_text(first.file).value(), "a recording");
}

TEST_F(BestRuns, are_ten_and_the_file_of_the_one_that_falls_out_is_removed) {
    for (int i = 0; i < 12; ++i) keep(100 + i, 1, static_cast<std::uint64_t>(i));
    EXPECT_EQ(scores().size(), kMostBestRuns);
    EXPECT_EQ(scores().front(), 111);
    EXPECT_EQ(scores().back(), 102);
    EXPECT_EQ(files(), kMostBestRuns);
    keep(101, 1, 50);
    EXPECT_EQ(scores().back(), 102) << "it is not among the best";
    EXPECT_EQ(files(), kMostBestRuns);
}

TEST_F(BestRuns, have_the_same_run_once) {
    keep(100, 2, 7);
    keep(100, 2, 7);
    EXPECT_EQ(scores(), std::vector<std::int64_t>{100});
    keep(100, 2, 8);
    EXPECT_EQ(scores().size(), 2u);
    // As another window may have written it at the same time.
    put("100_silver_2030-01-01_00-00-00_0000000000000007.couloir");
    EXPECT_EQ(scores().size(), 2u);
    keep(1, 0, 9);
    EXPECT_EQ(files(), 3u);
}

TEST_F(BestRuns, leave_files_of_other_names_alone) {
    keep(1, 1, 1);
    const std::vector<const char*> others{
        "notes.txt",
        "1_gold_2026-11-26_12-58-00_0123456789abcdef.couloir.part",
        "1_gold_2026-11-26_12-58-00_0123456789abcdef.txt",
        "1_gold_2026-11-26_12-58-00_0123456789abcde.couloir",
        "1_gold_2026-11-26_12-58-00_0123456789abcdef_2.couloir",
        "1_tin_2026-11-26_12-58-00_0123456789abcdef.couloir",
        "x_gold_2026-11-26_12-58-00_0123456789abcdef.couloir",
        "1x_gold_2026-11-26_12-58-00_0123456789abcdef.couloir",
        "99999999999999999999_gold_2026-11-26_12-58-00_0123456789abcdef.couloir",
        "1_gold_2026-11-2_12-58-00_0123456789abcdef.couloir",
        "1_gold_2026-11-26_12-58_0123456789abcdef.couloir",
        "1_gold.couloir",
        "_.couloir",
        ".couloir"};
    for (const char* name : others) put(name);
    EXPECT_EQ(scores(), std::vector<std::int64_t>{1});
    for (int i = 0; i < 12; ++i) keep(100 + i, 1, static_cast<std::uint64_t>(i));
    for (const char* name : others) EXPECT_EQ(read_text(best() / name).value(), "as it is") << name;
}

TEST_F(BestRuns, that_several_windows_add_at_once_are_all_kept) {
    constexpr int kWindows = 4, kEach = 25;
    std::vector<std::thread> windows;
    for (int window = 0; window < kWindows; ++window)
        windows.emplace_back([&, window] {
            for (int i = 0; i < kEach; ++i) {
                const int number = kEach * window + i;
                EXPECT_TRUE(
                    keep_run(best(), score_of(number, 1), static_cast<std::uint64_t>(number), "text"));
            }
        });
    for (std::thread& window : windows) window.join();
    EXPECT_EQ(scores(), (std::vector<std::int64_t>{99, 98, 97, 96, 95, 94, 93, 92, 91, 90}));
    EXPECT_EQ(files(), kMostBestRuns);
}

TEST_F(BestRuns, are_not_kept_in_a_folder_that_cannot_be_written) {
    std::ofstream(best()) << "a file, where the folder would be";
    const auto kept = keep_run(best(), score_of(1, 1), 1, "text");
    ASSERT_FALSE(kept);
    EXPECT_EQ(kept.error().status, Failure::kMachine);
    EXPECT_NE(kept.error().sentence.find(best().string()), std::string::npos) << kept.error().sentence;
}

TEST_F(BestRuns, of_each_challenge_have_a_folder_of_their_own) {
    const Scenario shipped = load_scene("quarry", {})->scenario;
    const auto folder = best_runs_folder(shipped);
    ASSERT_TRUE(folder);
    EXPECT_EQ(folder->parent_path(), folder_.path() / "couloir/best");
    EXPECT_EQ(folder->filename().string(), "quarry-" + challenge_id(shipped));
    Scenario seen = shipped;
    seen.title = "Another name", seen.light.azimuth_deg += 10, seen.terrain = "elsewhere";
    EXPECT_EQ(best_runs_folder(seen).value(), *folder) << "how it is drawn and called does not matter";
    Scenario easier = shipped;
    easier.goal->medals[0] -= 1;
    EXPECT_NE(best_runs_folder(easier).value(), *folder);
    Scenario lower = shipped;
    lower.bedrock[100] -= 1;
    EXPECT_NE(best_runs_folder(lower).value(), *folder);
    Overrides coarse;
    coarse.squares = 40;
    EXPECT_NE(best_runs_folder(load_scene("quarry", coarse)->scenario).value(), *folder);
}

TEST(RunExtent, is_what_the_flow_had_reached_by_the_end_of_each_step) {
    sim::State state = sim::make_state(support::plane(8, 5, 0.6).world(), {});
    RunExtent extent(state.grid, 100);
    const auto reach = [&](int x, std::int64_t tick, float depth) {
        state.rolling(x, 2) = depth;
        state.tick = tick;
        extent.see(state);
    };
    reach(1, 90, 0.2f);    // before the first action
    reach(2, 130, 0.09f);  // not deep enough
    reach(3, 130, 0.1f);
    reach(4, 131, 5);
    reach(1, 140, 0);  // it stays reached
    const auto columns_at = [&](std::int64_t ticks) {
        std::vector<std::uint8_t> inside;
        extent.at(ticks, inside);
        EXPECT_EQ(inside.size(), state.grid.size());
        std::string columns;
        for (std::size_t i = 0; i < inside.size(); ++i)
            if (inside[i] == 255) columns += std::to_string(i % static_cast<std::size_t>(state.grid.nx));
        return columns;
    };
    EXPECT_EQ(columns_at(-1), "");
    EXPECT_EQ(columns_at(0), "1");
    EXPECT_EQ(columns_at(29), "1");
    EXPECT_EQ(columns_at(30), "13");
    EXPECT_EQ(columns_at(59), "13");
    EXPECT_EQ(columns_at(60), "134");
    EXPECT_EQ(columns_at(1'000'000'000), "134");
}

class ResultCardText : public testing::Test {
  protected:
    ResultCardText() {
        scenario_.goal.emplace();
        scenario_.goal->medals = {-50, 100, 200};
    }
    std::string row(const char* label, const Score& score, std::span<const BestRun> earlier = {}) const {
        for (const ui::ResultCard::Row& each : card_of(scenario_, score, earlier).rows)
            if (each.label == label) return each.value;
        return "";
    }
    Scenario scenario_;
};

TEST_F(ResultCardText, tells_the_next_medal_or_by_how_little_it_was_missed) {
    EXPECT_EQ(row("Score", score_of(180, 2)), "180 (gold from 200)");
    EXPECT_EQ(row("Score", score_of(181, 2)), "181, 19 short of gold");
    EXPECT_EQ(row("Score", score_of(95, 1)), "95, 5 short of silver");
    EXPECT_EQ(row("Score", score_of(-51, 0)), "-51 (bronze from -50)") << "a tenth of it is nothing";
    EXPECT_EQ(row("Score", score_of(250, 3)), "250");
    EXPECT_EQ(row("Score", score_of(-12'345, 0)), "-12 345 (bronze from -50)");
}

TEST_F(ResultCardText, compares_with_the_best_run_before_it) {
    const std::vector<BestRun> earlier{{120, 2, "2026-11-26 12:58:00", 1, ""}};
    EXPECT_EQ(row("Best run", score_of(119, 2), earlier), "120, silver");
    EXPECT_EQ(row("Best run", score_of(120, 2), earlier), "120, silver");
    EXPECT_EQ(row("Best run", score_of(121, 2), earlier), "this one; before it 120");
    EXPECT_EQ(row("Best run", score_of(121, 2)), "this one");
    Score lost = score_of(500, 0);
    lost.needs.push_back({0, false});
    scenario_.goal->needs.emplace_back().most = 1;
    EXPECT_EQ(row("Best run", lost, earlier), "120, silver");
    EXPECT_EQ(row("Best run", lost), "") << "it is not kept";
    EXPECT_EQ(row("Score", lost), "none, because it is lost");
}

TEST_F(ResultCardText, tells_when_it_was_measured_what_a_slide_has_swept_along) {
    Score score = score_of(250, 3);
    score.tick = 1200;
    score.measures.run_out = 1367;
    score.measures.eroded = 249569;
    scenario_.params.tick_s = 0.25f;
    EXPECT_EQ(row("Run-out", score), "1 367 m");
    EXPECT_EQ(row("Swept along", score), "249 569 m³ by 300 s");
}

TEST(Verdict, has_as_many_digits_as_show_on_which_side_of_a_bound_a_value_is) {
    Goal::Need need;
    need.quantity.measure = Measure::kLoad;
    need.most = 4.9;
    const auto load = [&](std::int64_t value, bool met) { return text_of(need, {value, met}).value; };
    EXPECT_EQ(load(4949, false), "4.95 kPa");
    EXPECT_EQ(load(4901, false), "4.901 kPa");
    EXPECT_EQ(load(4900, true), "4.9 kPa");
    EXPECT_EQ(load(4851, true), "4.9 kPa");
    EXPECT_EQ(load(8249, false), "8.2 kPa");
    EXPECT_EQ(load(5000, false), "5 kPa");
    need = {};
    need.quantity.measure = Measure::kEroded;
    need.least = 3500;
    EXPECT_EQ(text_of(need, {3'499'600, false}).value, "3499.6 m3");
    EXPECT_EQ(text_of(need, {3'500'400, true}).value, "3500 m3");
    EXPECT_EQ(text_of(need, {3'500'400, true}).bound, "at least 3500 m3");
}

}  // namespace
}  // namespace game::test
