#include "game/session/perf_log.h"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/game/program.h"
#include "tests/support/allocations.h"
#include "tests/support/places.h"

namespace game::test {
namespace {

// The documented columns, in order.
constexpr const char* kColumns =
    "frame,tick,time_s,substeps,solve_ms,track_ms,gradient_ms,advect_ms,upload_ms,remesh_ms,surface_ms,"
    "shadow_ms,changes_ms,"
    "depth_ms,flow_ms,terrain_ms,surroundings_ms,sky_ms,structures_ms,trees_ms,powder_ms,tone_ms,edges_ms,"
    "draw_ms,frame_ms,"
    "active_cells,"
    "discontinuity_points,cut_triangles,mass_standing_m3,mass_rolling_m3,mass_out_m3,mass_error_m3,state_"
    "hash";

PerfRow row(std::int64_t tick, double solve_ms, std::optional<double> draw_ms) {
    PerfRow row;
    row.tick = tick;
    row.ms(Part::kSolve) = solve_ms;
    row.ms(Part::kDraw) = draw_ms;
    row.frame_ms = row.ms.sum();
    return row;
}

TEST(PerfLog, figures_are_nearest_ranks_over_the_ticks_in_which_a_stage_ran) {
    PerfLog log({"trial", "", 1, std::nullopt}, PerfLog::Keeps::kRows);
    for (const int ms : {20, 3, 1, 19, 18, 2, 17, 4, 16, 5, 15, 6, 14, 7, 13, 8, 12, 9, 11, 10})
        log.add(row(ms, ms, ms % 10 == 0 ? std::optional(100.0 * ms) : std::nullopt));
    const auto figures = log.figures();
    ASSERT_EQ(figures.size(), kPartCount + 1);
    const StageFigures &solve = figures[0], &track = figures[2], &draw = figures[8], &frame = figures[9];
    EXPECT_EQ(track.stage, "track");
    EXPECT_EQ(track.count, 0u);
    EXPECT_EQ(solve.stage, "solve");
    EXPECT_EQ(solve.count, 20u);
    EXPECT_DOUBLE_EQ(solve.mean, 10.5);
    EXPECT_DOUBLE_EQ(solve.median, 10);
    EXPECT_DOUBLE_EQ(solve.p95, 19);
    EXPECT_DOUBLE_EQ(solve.p99, 20);
    EXPECT_DOUBLE_EQ(solve.most, 20);
    EXPECT_DOUBLE_EQ(solve.total, 210);
    EXPECT_EQ(draw.stage, "draw");
    EXPECT_EQ(draw.count, 2u);
    EXPECT_DOUBLE_EQ(draw.mean, 1500);
    EXPECT_DOUBLE_EQ(draw.median, 1000);
    EXPECT_DOUBLE_EQ(draw.p95, 2000);
    EXPECT_EQ(frame.stage, "frame");
    EXPECT_DOUBLE_EQ(frame.total, 3210);
}

TEST(PerfLog, without_rows_takes_no_more_memory_and_has_the_same_figures_to_a_hundredth) {
    PerfLog rows({"trial", "", 1, std::nullopt}, PerfLog::Keeps::kRows);
    PerfLog figures({"trial", "", 1, std::nullopt}, PerfLog::Keeps::kFigures);
    std::int64_t most_allocations = 0;
    for (int i = 0; i < 20'000; ++i) {
        // From a nanosecond to some minutes, and zeros, when the stage did not run.
        const double ms = std::exp(std::fmod(i * 0.618, 1.0) * 27 - 14);
        const PerfRow each = row(i, ms, i % 7 == 0 ? std::optional(3 * ms) : std::nullopt);
        rows.add(each);
        const std::int64_t before = support::allocations();
        figures.add(each);
        most_allocations = std::max(most_allocations, support::allocations() - before);
    }
    EXPECT_EQ(most_allocations, 0);
    EXPECT_TRUE(figures.rows().empty());
    const auto exact = rows.figures(), close = figures.figures();
    ASSERT_EQ(exact.size(), close.size());
    for (std::size_t i = 0; i < exact.size(); ++i) {
        EXPECT_EQ(exact[i].stage, close[i].stage);
        EXPECT_EQ(exact[i].count, close[i].count);
        EXPECT_DOUBLE_EQ(exact[i].most, close[i].most);
        EXPECT_NEAR(exact[i].total, close[i].total, 1e-9 * exact[i].total);
        for (const auto& [one, other] : {std::pair{exact[i].median, close[i].median},
                                         {exact[i].p95, close[i].p95},
                                         {exact[i].p99, close[i].p99}})
            EXPECT_NEAR(one, other, 0.01 * one) << exact[i].stage;
    }
    EXPECT_NEAR(rows.to_json()["ticks_per_s"].get<double>(), figures.to_json()["ticks_per_s"].get<double>(),
                1e-6);
}

TEST(PerfLog, of_nothing_has_no_figures_and_divides_by_nothing) {
    const PerfLog log({"trial", "", 1, std::nullopt}, PerfLog::Keeps::kRows);
    for (const StageFigures& stage : log.figures()) {
        EXPECT_EQ(stage.count, 0u);
        EXPECT_EQ(stage.mean, 0);
    }
    EXPECT_EQ(log.to_json()["ticks_per_s"], 0);
}

TEST(PerfLog, json_gives_each_stage_its_share_of_the_frame) {
    PerfLog log({"trial", "", 3, std::nullopt}, PerfLog::Keeps::kRows);
    log.add(row(1, 10, 30));
    log.add(row(2, 10, std::nullopt));
    const Json json = log.to_json();
    EXPECT_EQ(json["threads"], 3);
    EXPECT_DOUBLE_EQ(json["stages"]["solve"]["share"], 0.4);
    EXPECT_DOUBLE_EQ(json["stages"]["draw"]["share"], 0.6);
    EXPECT_DOUBLE_EQ(json["ticks_per_s"], 40);
}

TEST(PerfLog, csv_has_the_documented_columns_in_every_row) {
    const support::TemporaryFolder folder;
    const auto path = folder.path() / "new folder" / "log.csv";
    PerfLog log({"trial, with a comma", "0123456789abcdef", 2,
                 render::DrawnBy{"llvmpipe", "64x36", render::Timing::kFinish}},
                PerfLog::Keeps::kRows);
    PerfRow full;
    full.tick = 7;
    full.time_s = 0.1166667;
    full.substeps = 3;
    full.ms(Part::kSolve) = 1.25;
    full.ms(Part::kTrack) = 0.5;
    full.ms(Part::kGradient) = 0.25;
    full.ms(Part::kAdvect) = 0.125;
    full.ms(Part::kHash) = 7;  // only in JSON
    full.ms.add({0.75, 0.875, 0.25, 0.5, 0.125, 0, 1, 0, 0.375, 0.25, 0.125});
    full.frame_ms = 3.75;
    full.active_cells = 42;
    full.points = 12;
    full.cut_triangles = 34;
    full.standing_m3 = 100.5;
    full.rolling_m3 = 20.25;
    full.out_m3 = 3.125;
    full.state_hash = 0x00000000deadbeefu;
    log.add(full);
    const double solve_ms = *full.ms(Part::kSolve);
    full.ms = {};
    full.ms(Part::kSolve) = solve_ms;
    full.points.reset(), full.cut_triangles.reset();
    log.add(full);
    ASSERT_TRUE(log.write_csv(path));

    std::istringstream stream(read_bytes(path));
    std::string line, heading;
    while (std::getline(stream, line) && line.rfind('#', 0) == 0) heading += line + "\n";
    for (const char* told : {"couloir ", "commit ", "-march=", "processor: ", "threads: 2",
                             "GL: llvmpipe; quality: 64x36; drawing timed by wall time around glFinish",
                             "trial, with a comma", "file hash 0123456789abcdef"})
        EXPECT_NE(heading.find(told), std::string::npos) << told << " is not in\n" << heading;
    EXPECT_EQ(line, kColumns);
    std::vector<std::string> rows;
    while (std::getline(stream, line)) rows.push_back(line);
    ASSERT_EQ(rows.size(), 2u);
    EXPECT_EQ(rows[0],
              "0,7,0.1167,3,1.2500,0.5000,0.2500,0.1250,0.7500,0.8750,0.2500,0.5000,0.1250,0.0000,1.0000,"
              "0.0000,0.3750,0.2500,0.1250,0.0000,0.0000,0.0000,0.0000,2.6250,3.7500,42,12,34,100.5000,20."
              "2500,3.1250,0.0000,"
              "00000000deadbeef");
    EXPECT_EQ(
        rows[1],
        "1,7,0.1167,3,1.2500,,,,,,,,,,,,,,,,,,,,3.7500,42,,,100.5000,20.2500,3.1250,0.0000,00000000deadbeef");
    for (const std::string& each : rows)
        EXPECT_EQ(std::count(each.begin(), each.end(), ','),
                  std::count(kColumns, kColumns + std::string(kColumns).size(), ','));
}

}  // namespace
}  // namespace game::test
