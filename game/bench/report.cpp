#include "game/bench/report.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "game/base/one_line.h"
#include "game/scene/memory.h"

namespace game {
namespace {

// Three significant digits: "0.0123", "1.23", "123".
std::string ms_text(double ms) {
    return ms <= 0 ? "0"
                   : fmt::format("{:.{}f}", ms,
                                 std::clamp(2 - static_cast<int>(std::floor(std::log10(ms))), 0, 4));
}
std::string ms_text(const std::optional<double>& ms) {
    return ms ? ms_text(*ms) : "";
}
std::string percent(double share) {
    return fmt::format("{:.{}f}", 100 * share, share < 0.00995 ? 2 : share < 0.0995 ? 1 : 0);
}

std::string grid_text(const sim::Grid& grid) {
    return fmt::format("{}x{}", grid.nx - 1, grid.ny - 1);
}

bool is_drawn(const FrameFigures& figures) {
    return figures.parts[static_cast<std::size_t>(Part::kDraw)].count > 0;
}

double bytes_per_vertex(const Measured& measured) {
    return measured.session_bytes / static_cast<double>(measured.grid.size());
}

Table times_table(const BenchReport& report) {
    Table table{"Milliseconds per tick, and per frame that draws it",
                {"recording", "grid", "physics", "state", "sub-steps", "tick", "p95", "p99", "frame", "p95",
                 "p99", "frames/s", "slow %", "repeats ±%", "B/vertex", "peak MiB"},
                {},
                4};
    for (const Measured& each : report.cases) {
        const FrameFigures f = frame_figures(each);
        const bool drawn = is_drawn(f);
        const auto of_frame = [&](double ms) { return drawn ? ms_text(ms) : ""; };
        table.rows.push_back(
            {one_line(each.recording), grid_text(each.grid), each.physics, std::string(to_string(each.proof)),
             each.rows.empty() ? "" : fmt::to_string(each.rows.front().substeps), ms_text(f.tick.median),
             ms_text(f.tick.p95), ms_text(f.tick.p99), of_frame(f.frame.median), of_frame(f.frame.p95),
             of_frame(f.frame.p99), fmt::format("{:.0f}", f.frames_per_s()), percent(f.slow),
             percent((each.slowest_by_fastest - 1) / 2), fmt::format("{:.0f}", bytes_per_vertex(each)),
             fmt::format("{:.0f}", static_cast<double>(each.peak_bytes) / static_cast<double>(kMiB))});
    }
    return table;
}

// Parts without drawing as shares of the tick, the others as shares of the frame. Software drawing takes so
// much of a frame that nothing else would show.
Table shares_table(const BenchReport& report) {
    Table table{"Where the time goes: % of the mean tick, and % of the mean frame",
                {"recording", "grid", "physics", "tick"},
                {},
                3};
    table.head.insert(table.head.end(), kPartNames.begin(), kPartNames.begin() + kTickParts);
    table.head.insert(table.head.end(), {"frame", "tick"});
    table.head.insert(table.head.end(), kPartNames.begin() + kTickParts, kPartNames.end());
    for (const Measured& each : report.cases) {
        const FrameFigures f = frame_figures(each);
        std::vector<std::string> row{one_line(each.recording), grid_text(each.grid), each.physics,
                                     ms_text(f.tick.mean)};
        const auto add = [&](double ms, double of, bool ran) {
            row.push_back(ran && of > 0 ? percent(ms / of) : "");
        };
        for (std::size_t part = 0; part < kTickParts; ++part)
            add(f.parts[part].mean, f.tick.mean, f.parts[part].count > 0);
        row.push_back(is_drawn(f) ? ms_text(f.frame_ms) : "");
        add(f.tick.mean, f.frame_ms, is_drawn(f));
        for (std::size_t part = kTickParts; part < kPartCount; ++part)
            add(f.parts[part].mean, f.frame_ms, f.parts[part].count > 0);
        table.rows.push_back(std::move(row));
    }
    return table;
}

// Ours with and without drawing, because a GPU of its time drew theirs.
Table paper_table(const BenchReport& report) {
    Table table{
        fmt::format(
            "Compared with the paper ({}): frames/s, share of the solver, and of velocities and textures "
            "while most vertices move, %",
            kPaperMachine),
        {"recording", "grid", "physics", "paper", "here", "times", "without drawing", "times",
         "solver, paper", "here", "of the tick", "textures, paper", "here"},
        {},
        3};
    for (const Measured& each : report.cases)
        for (const PaperScene& paper : kPaperScenes) {
            if (each.recording != paper.recording || each.squares != paper.squares) continue;
            const FrameFigures f = frame_figures(each);
            const bool drawn = is_drawn(f);
            const double ticks_per_s = f.tick.mean > 0 ? 1000 / f.tick.mean : 0;
            const double solve = f.parts[static_cast<std::size_t>(Part::kSolve)].mean;
            table.rows.push_back({one_line(each.recording), grid_text(each.grid), each.physics,
                                  fmt::format("{:.0f}", paper.frames_per_s),
                                  drawn ? fmt::format("{:.1f}", f.frames_per_s()) : "",
                                  drawn ? fmt::format("{:.2f}", f.frames_per_s() / paper.frames_per_s) : "",
                                  fmt::format("{:.0f}", ticks_per_s),
                                  fmt::format("{:.0f}", ticks_per_s / paper.frames_per_s),
                                  percent(paper.solve_share), drawn ? percent(f.share(Part::kSolve)) : "",
                                  f.tick.mean > 0 ? percent(solve / f.tick.mean) : "", paper.fronts_share,
                                  percent(f.busy_fronts)});
        }
    return table;
}

Table scaling_table(const Scaling& scaling) {
    Table table{fmt::format("{} in {} on each grid ({}): milliseconds, medians of {} ticks",
                            scaling.recording, scaling.physics, to_string(scaling.proof), scaling.ticks_each),
                {"grid", "s", "vertices", "moving", "points", "sub-steps", "B/vertex"},
                {}};
    for (const char* part : kPartNames) table.head.emplace_back(part);
    table.head.emplace_back("tick");
    for (const ScalingRow& row : scaling.rows) {
        std::vector<std::string> cells{
            fmt::to_string(row.squares),
            fmt::format("{:.0f}", row.time_s),
            fmt::to_string(row.vertices),
            fmt::to_string(row.moving),
            fmt::to_string(row.points),
            fmt::to_string(row.substeps),
            fmt::format("{:.0f}", row.session_bytes / static_cast<double>(row.vertices))};
        for (const auto& ms : row.ms) cells.push_back(ms_text(ms));
        cells.push_back(ms_text(row.ms.tick()));
        table.rows.push_back(std::move(cells));
    }
    return table;
}

Table exponents_table(const Scaling& scaling) {
    Table table{
        "Scaling: exponents by least squares of logarithms, and the share of the variance they explain",
        {"part", "vertices", "R²", "points of the front", "R²", "both: vertices", "points", "R²"},
        {}};
    for (const Exponents& each : exponents_of(scaling.rows)) {
        if (!each.by_vertices && !each.by_points) continue;
        std::vector<std::string> cells{each.part};
        const auto add = [&](const std::optional<PowerLaw>& law, std::size_t factors) {
            for (std::size_t f = 0; f < factors; ++f)
                cells.push_back(law ? fmt::format("{:.2f}", law->exponents[f]) : "");
            cells.push_back(law ? fmt::format("{:.2f}", law->r2) : "");
        };
        add(each.by_vertices, 1), add(each.by_points, 1), add(each.by_both, 2);
        table.rows.push_back(std::move(cells));
    }
    return table;
}

Json json_of(const Measured& each) {
    const FrameFigures f = frame_figures(each);
    std::vector<StageFigures> stages(f.parts.begin(), f.parts.end());
    stages.push_back(f.tick), stages.push_back(f.frame);
    Json json_stages = to_json(stages, 0);
    for (const StageFigures& stage : stages)
        json_stages[stage.stage]["share"] = f.frame_ms > 0 ? stage.mean / f.frame_ms : 0;
    Json json{{"recording", each.recording},
              {"file_hash", each.file_hash},
              {"squares", each.squares},
              {"cell_m", each.grid.dx},
              {"vertices", each.grid.size()},
              {"physics", each.physics},
              {"substeps", each.rows.empty() ? 0 : each.rows.front().substeps},
              {"ticks", each.rows.size()},
              {"repeats", each.repeats},
              {"slowest_by_fastest_repeat", each.slowest_by_fastest},
              {"proof", to_string(each.proof)}};
    if (!each.why.empty()) json["why"] = each.why;
    json["end_hash"] = each.rows.empty() ? "" : hex(each.rows.back().state_hash);
    json["ticks_per_s"] = f.tick.mean > 0 ? 1000 / f.tick.mean : 0;
    json["frames_per_s"] = f.frames_per_s();
    json["slow_share"] = f.slow;
    json["fronts_share_while_most_moves"] = f.busy_fronts;
    json["session_bytes_per_vertex"] = bytes_per_vertex(each);
    json["peak_bytes"] = each.peak_bytes;
    json["stages"] = std::move(json_stages);
    return json;
}

Json json_of(const std::optional<PowerLaw>& law) {
    return law ? Json{{"exponents", law->exponents}, {"r2", law->r2}} : Json();
}

Json json_of(const Scaling& scaling) {
    Json rows = Json::array(), exponents = Json::array();
    for (const ScalingRow& row : scaling.rows) {
        Json ms;
        for (std::size_t part = 0; part < kPartCount; ++part)
            if (row.ms[part]) ms[kPartNames[part]] = *row.ms[part];
        ms["tick"] = row.ms.tick();
        rows.push_back({{"squares", row.squares},
                        {"vertices", row.vertices},
                        {"time_s", row.time_s},
                        {"substeps", row.substeps},
                        {"moving_vertices", row.moving},
                        {"discontinuity_points", row.points},
                        {"session_bytes", row.session_bytes},
                        {"ms", ms}});
    }
    for (const Exponents& each : exponents_of(scaling.rows))
        exponents.push_back({{"part", each.part},
                             {"vertices", json_of(each.by_vertices)},
                             {"points", json_of(each.by_points)},
                             {"vertices_and_points", json_of(each.by_both)}});
    Json json{{"recording", scaling.recording},
              {"file_hash", scaling.file_hash},
              {"physics", scaling.physics},
              {"ticks_each", scaling.ticks_each},
              {"proof", to_string(scaling.proof)}};
    if (!scaling.why.empty()) json["why"] = scaling.why;
    json["rows"] = std::move(rows);
    json["exponents"] = std::move(exponents);
    return json;
}

std::string ms_cell(const std::optional<double>& ms) {
    return ms ? fmt::format("{:.4f}", *ms) : "";
}

std::string csv_of(const Scaling& scaling) {
    std::string csv =
        "recording,physics,squares,vertices,time_s,substeps,moving_vertices,discontinuity_points,session_"
        "bytes";
    for (const char* part : kPartNames) csv += fmt::format(",{}_ms", part);
    csv += '\n';
    for (const ScalingRow& row : scaling.rows) {
        csv +=
            fmt::format("{},{},{},{},{:.4f},{},{},{},{:.0f}", scaling.recording, scaling.physics, row.squares,
                        row.vertices, row.time_s, row.substeps, row.moving, row.points, row.session_bytes);
        for (const auto& ms : row.ms) csv += fmt::format(",{}", ms_cell(ms));
        csv += '\n';
    }
    return csv;
}

}  // namespace

std::optional<std::string> BenchReport::invalid() const {
    for (const Measured& each : cases)
        if (each.proof == Proof::kInvalid)
            return fmt::format("{} on {} squares in {} is invalid: {}", each.recording, each.squares,
                               each.physics, each.why);
    if (scaling && scaling->proof == Proof::kInvalid)
        return fmt::format("{} in {} is invalid: {}", scaling->recording, scaling->physics, scaling->why);
    return std::nullopt;
}

std::vector<Table> tables_of(const BenchReport& report) {
    std::vector<Table> tables;
    if (!report.cases.empty()) {
        tables.push_back(times_table(report));
        tables.push_back(shares_table(report));
        if (Table beside = paper_table(report); !beside.rows.empty()) tables.push_back(std::move(beside));
    }
    if (report.scaling) {
        tables.push_back(scaling_table(*report.scaling));
        tables.push_back(exponents_table(*report.scaling));
    }
    return tables;
}

Json to_json(const BenchReport& report) {
    Json json{{"format", kBenchFormat}, {"version", kBenchVersion}, {"valid", !report.invalid()}};
    json["surroundings"] = to_json(report.around);
    json["paper"] = Json::array();
    for (const PaperScene& paper : kPaperScenes)
        json["paper"].push_back({{"recording", paper.recording},
                                 {"squares", paper.squares},
                                 {"machine", kPaperMachine},
                                 {"frames_per_s", paper.frames_per_s},
                                 {"solve_share", paper.solve_share}});
    json["cases"] = Json::array();
    for (const Measured& each : report.cases) json["cases"].push_back(json_of(each));
    if (report.scaling) json["scaling"] = json_of(*report.scaling);
    return json;
}

std::string csv_of(const BenchReport& report) {
    std::string csv = to_text(report.around);
    if (report.scaling) return csv + csv_of(*report.scaling);
    for (const Measured& each : report.cases)
        csv += fmt::format("# {}, file hash {}; {} squares, {}: {}\n", each.recording, each.file_hash,
                           each.squares, each.physics, to_string(each.proof));
    csv += fmt::format("recording,squares,physics,{},hash_ms,peaks_ms\n", perf_columns());
    for (const Measured& each : report.cases)
        for (std::size_t i = 0; i < each.rows.size(); ++i)
            csv += fmt::format("{},{},{},{},{},{}\n", each.recording, each.squares, each.physics,
                               csv_line(i, each.rows[i]), ms_cell(each.rows[i].ms(Part::kHash)),
                               ms_cell(each.rows[i].ms(Part::kPeaks)));
    return csv;
}

}  // namespace game
