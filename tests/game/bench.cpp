#include <algorithm>
#include <cmath>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "game/analysis/trace.h"
#include "game/bench/against.h"
#include "game/bench/page.h"
#include "game/bench/report.h"
#include "game/files/assets.h"
#include "game/pages/plot.h"
#include "game/recording/recording_file.h"
#include "tests/game/program.h"
#include "tests/game/recording_files.h"
#include "tests/support/places.h"

// Tests of bench's evaluation, on invented measurements: no test reads a clock.

namespace game::test {
namespace {

constexpr double kSecondsPerTick = 1 / 60.0;  // s

PerfRow row_of(std::int64_t tick, double solve_ms, double track_ms, std::optional<double> draw_ms) {
    PerfRow row;
    row.tick = tick;
    row.time_s = static_cast<double>(tick) * kSecondsPerTick;
    row.substeps = 2;
    row.active_cells = static_cast<std::size_t>(100 * tick);
    row.points = 10;
    row.state_hash = 0xabc0 + static_cast<std::uint64_t>(tick);
    row.ms(Part::kSolve) = solve_ms;
    row.ms(Part::kTrack) = track_ms;
    row.ms(Part::kHash) = 0.25;
    if (draw_ms) row.ms.add({1, 2, *draw_ms});
    row.frame_ms = row.ms.sum();
    return row;
}

Measured measured_of(const std::string& recording, int squares, double slower = 1) {
    Measured each;
    each.recording = recording;
    each.file_hash = "0123456789abcdef";
    each.physics = "bcre-inertial";
    each.squares = squares;
    each.grid = {squares + 1, squares + 1, 2};
    each.tick_s = kSecondsPerTick;
    each.repeats = 3;
    for (int tick = 1; tick <= 10; ++tick)
        each.rows.push_back(
            row_of(tick, slower * tick, 0.5, tick % 5 == 0 ? std::optional(10.0) : std::nullopt));
    double begin_ms = 0;
    for (PerfRow& row : each.rows) row.begin_ms = begin_ms, begin_ms += row.frame_ms;
    each.last = each.rows;
    each.proof = Proof::kGolden;
    each.session_bytes = 1000.0 * static_cast<double>(each.grid.size());
    each.peak_bytes = 50 << 20;
    return each;
}

BenchReport report_of(double slower = 1) {
    BenchReport report;
    report.around.what = "trial";
    report.around.drawn = render::DrawnBy{"llvmpipe <8>", "64x36", render::Timing::kFinish};
    report.cases = {measured_of("landslide", 80, slower), measured_of("snow-avalanche", 160, slower)};
    return report;
}

Scaling scaling_of() {
    Scaling scaling;
    scaling.recording = "snow-avalanche";
    scaling.file_hash = "0123456789abcdef";
    scaling.physics = "bcre-inertial";
    scaling.ticks_each = 9;
    for (const int squares : {40, 80, 160, 320})
        for (const int seconds : {5, 15}) {
            ScalingRow row;
            row.squares = squares;
            row.vertices = static_cast<std::size_t>((squares + 1) * (squares + 1));
            row.time_s = seconds;
            row.points = static_cast<std::size_t>(squares * seconds);
            row.session_bytes = 100.0 * static_cast<double>(row.vertices);
            row.ms(Part::kSolve) = 1e-5 * static_cast<double>(row.vertices);
            row.ms(Part::kTrack) = 1e-3 * static_cast<double>(row.points);
            scaling.rows.push_back(row);
        }
    return scaling;
}

TEST(PowerLaw, of_invented_costs_is_recovered) {
    const std::vector<std::vector<double>> factors{{10, 20, 40, 80, 160, 320}, {3, 9, 5, 30, 11, 70}};
    std::vector<double> costs;
    for (std::size_t i = 0; i < factors[0].size(); ++i)
        costs.push_back(0.07 * std::pow(factors[0][i], 1.5) * std::pow(factors[1][i], -0.25));
    const auto law = fit_power_law(costs, factors);
    ASSERT_TRUE(law);
    EXPECT_NEAR(law->exponents[0], 1.5, 1e-9);
    EXPECT_NEAR(law->exponents[1], -0.25, 1e-9);
    EXPECT_NEAR(law->r2, 1, 1e-9);

    const auto alone = fit_power_law(costs, std::span(factors).first(1));
    ASSERT_TRUE(alone);
    EXPECT_LT(alone->exponents[0], 1.5);  // it is credited with the other factor's share
    EXPECT_GT(alone->r2, 0.9);
    EXPECT_LT(alone->r2, 1 - 1e-6);
}

TEST(PowerLaw, skips_values_without_a_logarithm) {
    const std::vector<std::vector<double>> factors{{1, 2, 0, 4, 8, 16}};
    const std::vector<double> costs{1, 4, 7, 16, 0, 256};
    const auto law = fit_power_law(costs, factors);
    ASSERT_TRUE(law);
    EXPECT_NEAR(law->exponents[0], 2, 1e-9);
}

TEST(PowerLaw, is_none_if_the_factors_do_not_determine_it) {
    const std::vector<double> costs{1, 2, 3, 4};
    const std::vector<std::vector<double>> same{{5, 5, 5, 5}}, together{{1, 2, 4, 8}, {1, 4, 16, 64}},
        few{{1, 2, 0, 0}};
    EXPECT_FALSE(fit_power_law(costs, same));
    EXPECT_FALSE(fit_power_law(costs, together));
    EXPECT_FALSE(fit_power_law(costs, few));
    EXPECT_FALSE(fit_power_law({}, std::vector<std::vector<double>>(1)));
}

TEST(Exponents, separate_growth_with_vertices_from_growth_with_the_front) {
    for (const Exponents& each : exponents_of(scaling_of().rows)) {
        if (each.part == "solve") {
            ASSERT_TRUE(each.by_vertices && each.by_both);
            EXPECT_NEAR(each.by_vertices->exponents[0], 1, 1e-6);
            EXPECT_NEAR(each.by_both->exponents[0], 1, 1e-6);
            EXPECT_NEAR(each.by_both->exponents[1], 0, 1e-6);
        }
        if (each.part == "track") {
            ASSERT_TRUE(each.by_points && each.by_both);
            EXPECT_NEAR(each.by_points->exponents[0], 1, 1e-6);
            EXPECT_NEAR(each.by_both->exponents[0], 0, 1e-6);
            EXPECT_NEAR(each.by_both->exponents[1], 1, 1e-6);
            EXPECT_LT(each.by_vertices->r2, 0.99);
        }
        if (each.part == "draw") {
            EXPECT_FALSE(each.by_vertices || each.by_points || each.by_both);
        }
    }
}

TEST(Medians, are_of_each_tick_and_part_over_the_repeats) {
    std::vector<std::vector<PerfRow>> repeats;
    for (const double ms : {3.0, 1.0, 100.0})
        repeats.push_back({row_of(1, ms, 10 - ms / 100, std::nullopt), row_of(2, 2 * ms, 5, ms)});
    const auto rows = medians_of(repeats);
    ASSERT_EQ(rows.size(), 2u);
    EXPECT_DOUBLE_EQ(*rows[0].ms(Part::kSolve), 3);
    EXPECT_DOUBLE_EQ(*rows[0].ms(Part::kTrack), 9.97);
    EXPECT_FALSE(rows[0].ms.drawn());
    EXPECT_DOUBLE_EQ(rows[0].frame_ms, 3 + 9.97 + 0.25);
    EXPECT_DOUBLE_EQ(*rows[1].ms(Part::kSolve), 6);
    EXPECT_DOUBLE_EQ(*rows[1].ms(Part::kDraw), 3);
    ASSERT_TRUE(rows[1].ms.passes);
    EXPECT_DOUBLE_EQ((*rows[1].ms.passes)(render::Pass::kSurface), 3);
    EXPECT_DOUBLE_EQ(rows[1].begin_ms, rows[0].frame_ms);
}

TEST(FrameFigures, have_shares_that_add_up_and_count_only_drawn_frames) {
    const FrameFigures figures = frame_figures(measured_of("landslide", 80));
    // Ticks of 1.75 to 10.75 ms; two of them with 13 ms of drawing.
    EXPECT_DOUBLE_EQ(figures.tick.mean, 6.25);
    EXPECT_DOUBLE_EQ(figures.tick.median, 5.75);
    EXPECT_DOUBLE_EQ(figures.frame_ms, 19.25);
    EXPECT_EQ(figures.frame.count, 2u);
    EXPECT_DOUBLE_EQ(figures.frame.most, 23.75);
    EXPECT_DOUBLE_EQ(figures.slow, 1);  // 18.75 and 23.75 ms to show 16.7
    double shares = 0;
    for (std::size_t part = 0; part < kPartCount; ++part) shares += figures.share(static_cast<Part>(part));
    EXPECT_NEAR(shares, 1, 1e-12);
    // While at least 800 vertices move: three ticks of 8.75, 9.75 and 10.75 ms.
    EXPECT_NEAR(figures.busy_fronts, 1.5 / (29.25 + 3 * 13), 1e-12);

    Measured undrawn = measured_of("landslide", 80);
    for (PerfRow& row : undrawn.rows) {
        for (const Part part : {Part::kUpload, Part::kRemesh, Part::kDraw}) row.ms(part).reset();
        row.frame_ms = row.ms.sum();
    }
    const FrameFigures bare = frame_figures(undrawn);
    EXPECT_DOUBLE_EQ(bare.frame_ms, 6.25);
    EXPECT_EQ(bare.frame.count, 10u);
    EXPECT_DOUBLE_EQ(bare.slow, 0);
}

TEST(Trace, is_json_with_consecutive_parts_within_their_frames) {
    const Measured a = measured_of("land \"slide\"", 80), b = measured_of("snow", 160);
    const TracedRun runs[] = {{a.recording, a.last}, {b.recording, b.last}};
    const Json trace = Json::parse(trace_of(runs));
    double frame_begin = 0, frame_end = 0, part_end = 0;
    int frames = 0, parts = 0, names = 0, counts = 0;
    for (const Json& event : trace["traceEvents"]) {
        names += event["ph"] == "M";
        counts += event["ph"] == "C";
        if (event["ph"] != "X") continue;
        const double begin = event["ts"], end = begin + event["dur"].get<double>();
        constexpr double kRounding = 0.01;  // µs
        if (event["name"] == "frame") {
            EXPECT_GE(begin, frame_end - kRounding);
            frame_begin = part_end = begin, frame_end = end, ++frames;
        } else {
            EXPECT_GE(begin, part_end - kRounding) << event;
            EXPECT_GE(begin, frame_begin - kRounding) << event;
            EXPECT_LE(end, frame_end + kRounding) << event;
            part_end = end, ++parts;
        }
    }
    EXPECT_EQ(frames, 20);
    EXPECT_EQ(parts, 20 * 3 + 4 * 3);
    EXPECT_EQ(names, 2);
    EXPECT_EQ(counts, 40);
    EXPECT_EQ(trace["traceEvents"][0]["args"]["name"], "land \"slide\"");
}

TEST(BenchReport, has_the_papers_figures_beside_ours_and_names_what_is_invalid) {
    BenchReport report = report_of();
    EXPECT_FALSE(report.invalid());
    const auto tables = tables_of(report);
    ASSERT_EQ(tables.size(), 3u);
    ASSERT_EQ(tables[2].rows.size(), 2u);
    EXPECT_EQ(tables[2].rows[0][3], "25");
    EXPECT_EQ(tables[2].rows[1][3], "7");
    for (const Table& table : tables)
        for (const auto& row : table.rows) EXPECT_EQ(row.size(), table.head.size()) << table.title;

    report.cases[1].proof = Proof::kInvalid;
    report.cases[1].why = "its repeats part at tick 7";
    EXPECT_EQ(report.invalid(),
              "snow-avalanche on 160 squares in bcre-inertial is invalid: its repeats part at tick 7");
    EXPECT_EQ(to_json(report)["valid"], false);
    EXPECT_NE(as_text(tables_of(report)[0]).find("INVALID"), std::string::npos);
}

TEST(BenchReport, csv_has_as_many_cells_in_every_line_as_names) {
    for (const bool scaling : {false, true}) {
        BenchReport report = report_of();
        if (scaling) report.scaling = scaling_of();
        std::istringstream csv(csv_of(report));
        std::ptrdiff_t commas = -1;
        int lines = 0;
        for (std::string line; std::getline(csv, line);) {
            if (line[0] == '#') continue;
            const auto here = std::count(line.begin(), line.end(), ',');
            if (commas < 0) commas = here;
            EXPECT_EQ(here, commas) << line;
            ++lines;
        }
        EXPECT_EQ(lines, scaling ? 1 + 8 : 1 + 20);
        for (const char* told : {"commit", "processor", "threads", "llvmpipe", "quality: 64x36", "glFinish"})
            EXPECT_NE(csv_of(report).find(told), std::string::npos) << told;
    }
    EXPECT_NE(csv_of(report_of()).find("landslide, file hash 0123456789abcdef"), std::string::npos);
}

TEST(BenchPage, is_self_contained_and_complete) {
    BenchReport report = report_of();
    report.scaling = scaling_of();
    const auto tables = tables_of(report);
    const std::string page = page_of(report, tables);
    for (const char* elsewhere :
         {"http", "<script", "src=", "href=", "url(", "@import", "<link", "nan", "inf"})
        EXPECT_EQ(page.find(elsewhere), std::string::npos) << elsewhere;
    for (const Table& table : tables) EXPECT_NE(page.find(as_html(table)), std::string::npos) << table.title;
    const auto count = [&](const std::string& what) {
        int found = 0;
        for (auto at = page.find(what); at != std::string::npos; at = page.find(what, at + 1)) ++found;
        return found;
    };
    EXPECT_EQ(count("<svg"), 2 + 2 + 2 * 2);  // bars, scaling, and two for each case
    EXPECT_EQ(count("<svg"), count("</svg>"));
    EXPECT_EQ(count("<figure>"), count("</figure>"));
    EXPECT_NE(page.find("llvmpipe &lt;8&gt;"), std::string::npos);
    EXPECT_EQ(page.find("Not valid"), std::string::npos);
    report.cases[0].proof = Proof::kInvalid;
    EXPECT_NE(page_of(report, tables).find("Not valid"), std::string::npos);
}

TEST(Plot, has_round_numbers_at_its_axes) {
    EXPECT_EQ(round_numbers(0, 10, 5), (std::vector<double>{0, 2, 4, 6, 8, 10}));
    EXPECT_EQ(round_numbers(0, 0.9, 5), (std::vector<double>{0, 0.2, 0.4, 0.6000000000000001, 0.8}));
    EXPECT_EQ(round_numbers(3, 3, 5), (std::vector<double>{3}));
}

// Writes a report and reads it back.
class Against : public testing::Test {
  protected:
    std::filesystem::path write(const std::string& text) {
        const auto path = folder.path() / "then.json";
        write_bytes(path, text);
        return path;
    }
    static std::vector<BenchEntry> entries(const BenchReport& report) {
        return entries_of(to_json(report)).value();
    }
    support::TemporaryFolder folder;
};

TEST_F(Against, finds_no_difference_to_itself) {
    BenchReport report = report_of();
    report.scaling = scaling_of();
    const auto then = read_report(write(printed(to_json(report))));
    ASSERT_TRUE(then) << then.error().sentence;
    const BenchComparison same = compare_entries(entries(report), entries_of(*then).value(), 0.001);
    EXPECT_GT(same.compared, 10u);
    EXPECT_EQ(same.compared, same.table.rows.size());
    EXPECT_FALSE(same.too_slow);
    EXPECT_TRUE(same.remarks.empty());
}

TEST_F(Against, reports_the_worst_beyond_the_tolerance_and_accepts_the_rest) {
    const auto then = entries(report_of()), now = entries(report_of(1.2));
    EXPECT_FALSE(compare_entries(now, then, 0.25).too_slow);
    const auto slow = compare_entries(now, then, 0.1);
    ASSERT_TRUE(slow.too_slow);
    EXPECT_NE(slow.too_slow->find("solve of landslide 80 bcre-inertial"), std::string::npos);
    EXPECT_FALSE(compare_entries(then, now, 0).too_slow);  // faster is fine
}

TEST_F(Against, remarks_on_what_is_not_the_same_work) {
    BenchReport other = report_of();
    other.cases[0].rows.back().state_hash = 1;
    other.cases[1].squares = 320;
    const auto compared = compare_entries(entries(other), entries(report_of()), 0.25);
    ASSERT_EQ(compared.remarks.size(), 2u);
    EXPECT_NE(compared.remarks[0].find("landslide 80 bcre-inertial ended in another state"),
              std::string::npos);
    EXPECT_EQ(compared.remarks[1], "snow-avalanche 320 bcre-inertial is not in the earlier run");
}

TEST_F(Against, refuses_a_damaged_report_with_one_sentence) {
    const std::string whole = printed(to_json(report_of()));
    const auto with = [&](const std::string& from, const std::string& to) {
        std::string text = whole;
        const auto at = text.find(from);
        EXPECT_NE(at, std::string::npos) << from;
        return text.replace(at, from.size(), to);
    };
    const std::pair<std::string, const char*> damaged[] = {
        {"", "not JSON"},
        {whole.substr(0, whole.size() / 2), "not JSON"},
        {"[]", "is not a report"},
        {R"({"format":"else"})", "is not a report"},
        {with("\"version\": 1", "\"version\": 2"), "another version"},
        {with("\"cases\"", "\"boxes\""), "has no \"cases\""},
        {with("\"end_hash\"", "\"hash\""), "has no \"end_hash\""},
        {with("\"median_ms\": ", "\"median_ms\": -"), "\"median_ms\" that is not a number"},
        {with("\"count\": 10", "\"count\": \"ten\""), "\"count\" that is not a number"},
    };
    for (const auto& [text, told] : damaged) {
        const auto path = write(text);
        const auto read = read_report(path);
        ASSERT_FALSE(read) << told;
        EXPECT_EQ(read.error().status, Failure::kUnusable);
        EXPECT_EQ(read.error().sentence.rfind(path.string() + ": ", 0), 0u) << read.error().sentence;
        EXPECT_NE(read.error().sentence.find(told), std::string::npos) << read.error().sentence;
    }
    EXPECT_FALSE(read_report(folder.path() / "nothing.json"));
}

Scenario shipped(const std::string& name) {
    return read_recording(find_asset(AssetKind::kRecording, name).value()).value().header.scenario;
}

// Without the numbers of other models, whose defaults a recording keeps.
sim::Params used(const sim::Params& params) {
    sim::Params kept = params;
    for (const sim::ParamInfo& info : sim::kParams)
        if (!sim::is_used_by(info, params.model)) kept.*info.value = sim::Params{}.*info.value;
    return kept;
}

TEST(BenchPhysics, of_a_landslide_in_bcre_are_the_recorded_ones) {
    const Scenario own = shipped("landslide"), bcre = shipped("landslide-bcre");
    const auto local = bench_physics_named("local-lax-friedrichs").value();
    EXPECT_FALSE(is_own(own, local));
    EXPECT_TRUE(is_own(bcre, local));
    EXPECT_EQ(used(in_physics(own, local).value().params), used(bcre.params));
    EXPECT_EQ(in_physics(bcre, local).value().params, bcre.params);
    sim::Params lax = used(bcre.params);
    lax.scheme = sim::Scheme::kLaxFriedrichs;
    EXPECT_EQ(used(in_physics(own, bench_physics_named("lax-friedrichs").value()).value().params), lax);
    EXPECT_EQ(in_physics(own, bench_physics_named("bcre-inertial").value()).value().params, own.params);
    EXPECT_FALSE(bench_physics_named("muscl"));
}

TEST(BenchPhysics, of_an_unknown_material_is_refused) {
    Scenario scenario = small_scenario();
    scenario.material = "cheese";
    EXPECT_FALSE(in_physics(scenario, bench_physics_named("lax-friedrichs").value()));
    EXPECT_TRUE(in_physics(scenario, bench_physics_named("bcre-inertial").value()));
}

double mean(const std::vector<float>& depth) {
    double sum = 0;
    for (const float each : depth) sum += static_cast<double>(each);
    return sum / static_cast<double>(depth.size());
}

TEST(OnGrid, refuses_a_forest_earth_and_mixed_layers_of_another_grid) {
    for (int i = 0; i < 3; ++i) {
        Scenario scenario = small_scenario();
        const std::size_t vertices = scenario.grid.size();
        if (i == 0) scenario.standing.forest.resize(vertices);
        if (i == 1) scenario.standing.earth.resize(vertices);
        if (i == 2)
            scenario.lower = {
                "soil", scenario.params, std::vector<float>(vertices), {}, std::vector<float>(vertices), {}};
        EXPECT_TRUE(on_grid(scenario, 12, {})) << i;
        const auto other = on_grid(scenario, 24, {});
        ASSERT_FALSE(other) << i;
        EXPECT_NE(other.error().sentence.find("12 squares"), std::string::npos) << other.error().sentence;
    }
}

TEST(OnGrid, keeps_the_rectangle_the_slope_and_how_deep_the_cover_is) {
    const Scenario scenario = shipped("snow-avalanche");
    for (const int squares : {40, 80, 160, 320}) {
        const Scenario other = on_grid(scenario, squares).value();
        EXPECT_EQ(other.grid.nx, squares + 1);
        EXPECT_EQ(other.grid.ny, squares + 1);
        EXPECT_NEAR(static_cast<double>(other.grid.dx) * squares, 2000, 0.01);
        EXPECT_NEAR(mean(other.depth) / mean(scenario.depth), 1, 0.02) << squares;
        for (const float depth : other.depth) EXPECT_GE(depth, 0);
        EXPECT_EQ(std::count(other.has_data.begin(), other.has_data.end(), 0), 0);
    }
    EXPECT_EQ(on_grid(scenario, 160).value().bedrock, scenario.bedrock);
    EXPECT_FALSE(on_grid(scenario, 5));

    Scenario plane = small_scenario();
    for (int y = 0; y < plane.grid.ny; ++y)
        for (int x = 0; x < plane.grid.nx; ++x)
            plane.bedrock[static_cast<std::size_t>(y * plane.grid.nx + x)] =
                2.f * static_cast<float>(x) - 3.f * static_cast<float>(y);
    const Scenario finer = on_grid(plane, 30).value();
    for (int y = 0; y < finer.grid.ny; ++y)
        for (int x = 0; x < finer.grid.nx; ++x) {
            if (finer.has_data[static_cast<std::size_t>(y * finer.grid.nx + x)] == 0)
                continue;  // interpolated
            const double cells = static_cast<double>(finer.grid.dx / plane.grid.dx);
            EXPECT_NEAR(finer.bedrock[static_cast<std::size_t>(y * finer.grid.nx + x)],
                        cells * (2 * x - 3 * y), 1e-3);
        }
    EXPECT_GT(std::count(finer.has_data.begin(), finer.has_data.end(), 1), 600);
    // The corner without data stays without data, and is empty.
    EXPECT_EQ(finer.has_data[0], 0);
    EXPECT_EQ(finer.depth[0], 0);
}

// The program itself, on a one-second recording.
class BenchProgram : public testing::Test {
  protected:
    void SetUp() override {
        path = folder.path() / "small.couloir";
        record(path, small_scenario(), 60, some_commands());
    }
    Finished bench(std::vector<std::string> more, const std::string& squares = "12") const {
        std::vector<std::string> arguments{"bench",         path.string(), "--grid",    squares, "--physics",
                                           "bcre-inertial", "--no-render", "--repeats", "2"};
        arguments.insert(arguments.end(), more.begin(), more.end());
        return couloir(arguments);
    }
    std::string at(const char* name) const { return (folder.path() / name).string(); }

    support::TemporaryFolder folder;
    std::filesystem::path path;
};

TEST_F(BenchProgram, measures_a_recording_and_writes_all_results) {
    const Finished done = bench(
        {"--summary", at("a.json"), "--perf", at("a.csv"), "--page", at("a.html"), "--trace", at("t.json")},
        "12,20");
    ASSERT_EQ(done.status, 0) << done.err;
    EXPECT_EQ(done.err, "");
    EXPECT_NE(done.out.find("golden"), std::string::npos);
    EXPECT_NE(done.out.find("unverified"), std::string::npos);
    const Json report = Json::parse(read_bytes(at("a.json")));
    EXPECT_EQ(report["valid"], true);
    ASSERT_EQ(report["cases"].size(), 2u);
    EXPECT_EQ(report["cases"][0]["proof"], "golden");
    EXPECT_EQ(report["cases"][1]["proof"], "unverified");
    EXPECT_EQ(report["cases"][0]["ticks"], 60);
    EXPECT_EQ(report["cases"][0]["repeats"], 2);
    const std::string csv = read_bytes(at("a.csv"));
    EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n') - std::count(csv.begin(), csv.end(), '#'), 1 + 120);
    EXPECT_NE(read_bytes(at("a.html")).find("</html>"), std::string::npos);
    EXPECT_GT(Json::parse(read_bytes(at("t.json")))["traceEvents"].size(), 120u);
}

TEST_F(BenchProgram, calls_a_run_invalid_if_a_recorded_hash_differs) {
    auto bodies = bodies_of(read_bytes(path));
    for (std::string& body : bodies) {
        Json line = json_of(body);
        if (line.value("tick", -1) != 30 || !line.contains("hash")) continue;
        line["hash"] = "0123456789abcdef";
        body = body_of(line);
    }
    write_bytes(path, chained(bodies));
    const Finished done = bench({"--summary", at("a.json")});
    EXPECT_EQ(done.status, 1);
    EXPECT_NE(done.err.find("invalid: at tick 30"), std::string::npos) << done.err;
    EXPECT_NE(done.out.find("INVALID"), std::string::npos);
    const Json report = Json::parse(read_bytes(at("a.json")));
    EXPECT_EQ(report["valid"], false);
    EXPECT_EQ(report["cases"][0]["proof"], "INVALID");
    // Earlier ticks are still valid, and so is another grid.
    EXPECT_EQ(bench({"--ticks", "29"}).status, 0);
    EXPECT_EQ(
        couloir({"bench", path.string(), "--grid", "20", "--physics", "bcre-inertial", "--no-render"}).status,
        0);
}

TEST_F(BenchProgram, compares_with_an_earlier_run) {
    const auto run = [&](std::vector<std::string> more) {
        more.insert(more.end(), {"--ticks", "10"});
        return bench(std::move(more), "200");
    };
    ASSERT_EQ(run({"--summary", at("then.json")}).status, 0);
    Json then = Json::parse(read_bytes(at("then.json")));
    EXPECT_EQ(run({"--against", at("then.json"), "--tolerance", "1e6"}).status, 0);
    EXPECT_EQ(run({"--against", at("then.json"), "--tolerance", "1e6"}).out.find("bcre-inertial  frame"),
              std::string::npos);  // nothing was drawn
    // As if 40,000 vertices had taken no longer than 0.01 ms.
    for (auto& [name, stage] : then["cases"][0]["stages"].items())
        stage["median_ms"] = name == "tick" ? 0.0101 : 0.0;
    write_bytes(at("then.json"), then.dump());
    const Finished slow = run({"--against", at("then.json"), "--tolerance", "1e-6"});
    EXPECT_EQ(slow.status, 1);
    EXPECT_NE(slow.err.find("times as long as then"), std::string::npos) << slow.err;
    write_bytes(at("then.json"), "{");
    const Finished refused = run({"--against", at("then.json")});
    EXPECT_EQ(refused.status, 2);
    EXPECT_EQ(std::count(refused.err.begin(), refused.err.end(), '\n'), 1) << refused.err;
    EXPECT_EQ(refused.out, "");
}

TEST_F(BenchProgram, refuses_what_it_cannot_measure) {
    const std::pair<std::vector<std::string>, const char*> wrong[] = {
        {{"bench", "nowhere"}, "nowhere"},
        {{"bench", "--grid", "5"}, "--grid"},
        {{"bench", "--physics", "muscl"},
         "'muscl' is not one of: bcre-inertial, lax-friedrichs, local-lax-friedrichs"},
        {{"bench", "--repeats", "0"}, "--repeats"},
        {{"bench", "--tolerance", "-1"}, "--tolerance"},
        {{"bench", "--scaling", "--trace", "t.json"}, "--trace"},
        {{"bench", "--scaling", path.string(), "--no-render"}, "second 5"},
    };
    for (const auto& [arguments, told] : wrong) {
        const Finished done = couloir(arguments);
        EXPECT_EQ(done.status, 2) << told;
        EXPECT_NE(done.err.find(told), std::string::npos) << done.err;
        EXPECT_EQ(std::count(done.err.begin(), done.err.end(), '\n'), 1) << done.err;
    }
}

TEST_F(BenchProgram, and_a_replay_leave_a_trace) {
    const Finished done = couloir({"replay", path.string(), "--trace", at("t.json")});
    ASSERT_EQ(done.status, 0) << done.err;
    std::map<std::string, int> count;
    const Json trace = Json::parse(read_bytes(at("t.json")));
    for (const Json& event : trace["traceEvents"]) ++count[event["name"].get<std::string>()];
    for (const char* part : {"frame", "solve", "track", "advect", "gradient", "peaks", "hash"})
        EXPECT_EQ(count[part], 60) << part;
    EXPECT_EQ(count["draw"], 0);
}

TEST_F(BenchProgram, scales_over_grids) {
    record(path, small_scenario(), 320, some_commands());
    const Finished done = couloir({"bench", "--scaling", path.string(), "--grid", "12,24,48", "--no-render",
                                   "--perf", at("s.csv"), "--json"});
    ASSERT_EQ(done.status, 0) << done.err;
    const Json scaling = Json::parse(done.out)["scaling"];
    EXPECT_EQ(scaling["rows"].size(), 3u);
    EXPECT_EQ(scaling["proof"], "golden");
    EXPECT_EQ(scaling["rows"][2]["squares"], 48);
    EXPECT_NE(read_bytes(at("s.csv")).find("small,bcre-inertial,24,"), std::string::npos);
}

}  // namespace
}  // namespace game::test
