#include "game/perf_log.h"

#include <algorithm>
#include <cmath>
#include <fstream>

#include <fmt/format.h>

#include "game/text_file.h"
#include "game/version.h"

namespace game {
namespace {

constexpr const char* kColumns =
    "frame,tick,time_s,substeps,solve_ms,track_ms,gradient_ms,advect_ms,upload_ms,remesh_ms,draw_ms,frame_ms,"
    "active_cells,"
    "discontinuity_points,cut_triangles,mass_standing_m3,mass_rolling_m3,mass_out_m3,mass_error_m3,state_"
    "hash\n";

std::string processor() {
    std::ifstream info("/proc/cpuinfo");
    for (std::string line; std::getline(info, line);)
        if (line.rfind("model name", 0) == 0) return line.substr(std::min(line.size(), line.find(':') + 2));
    return "unknown";
}

std::string csv_line(std::size_t frame, const PerfRow& row) {
    const std::string draw = row.draw_ms ? fmt::format("{:.4f}", *row.draw_ms) : "";
    const auto& fronts = row.fronts;
    const std::string followed =
        fronts ? fmt::format("{:.4f},{:.4f},{:.4f}", fronts->track_ms, fronts->gradient_ms, fronts->advect_ms)
               : ",,";
    const std::string found = fronts ? fmt::format("{},{}", fronts->points, fronts->cut_triangles) : ",";
    return fmt::format("{},{},{:.4f},{},{:.4f},{},,,{},{:.4f},{},{},{:.4f},{:.4f},{:.4f},{:.4f},{}\n", frame,
                       row.tick, row.time_s, row.substeps, row.solve_ms, followed, draw, row.frame_ms,
                       row.active_cells, found, row.standing_m3, row.rolling_m3, row.out_m3, row.error_m3,
                       hex(row.state_hash));
}

StageFigures figures_of(std::string stage, std::vector<double> ms) {
    StageFigures figures{std::move(stage), ms.size()};
    if (ms.empty()) return figures;
    std::sort(ms.begin(), ms.end());
    // Nearest rank: the smallest value that at least this share does not exceed.
    const auto rank = [&](double share) {
        const auto n = static_cast<std::size_t>(std::ceil(share * static_cast<double>(ms.size())));
        return ms[std::clamp<std::size_t>(n, 1, ms.size()) - 1];
    };
    for (const double each : ms) figures.total += each;
    figures.mean = figures.total / static_cast<double>(ms.size());
    figures.median = rank(0.5);
    figures.p95 = rank(0.95);
    figures.p99 = rank(0.99);
    figures.most = ms.back();
    return figures;
}

// What the paper reports of its own scenes (Section 5.1; Intel i7-3770K, NVIDIA GTX 660).
Json paper_figures() {
    return {{"landslide_80x80", {{"frames_per_s", 25}, {"solve_share", 0.10}}},
            {"snow_avalanche_160x160", {{"frames_per_s", 7}, {"solve_share", 0.14}}}};
}

}  // namespace

Outcome<void> PerfLog::write_csv(const std::filesystem::path& path) const {
    std::string text = fmt::format(
        "# {}, commit {}\n# {}\n# processor: {}; threads: {}\n# GL: {}\n# of: {}{}\n", kProgram, kCommit,
        kCompiler, processor(), surroundings_.threads,
        surroundings_.gl_renderer.empty() ? "none, nothing was drawn" : surroundings_.gl_renderer,
        surroundings_.what, surroundings_.file_hash.empty() ? "" : ", file hash " + surroundings_.file_hash);
    text += kColumns;
    for (std::size_t i = 0; i < rows_.size(); ++i) text += csv_line(i, rows_[i]);
    return write_text(path, text);
}

std::vector<StageFigures> PerfLog::figures() const {
    std::vector<double> solve, track, gradient, advect, draw, frame;
    for (const PerfRow& row : rows_) {
        solve.push_back(row.solve_ms);
        if (const auto& fronts = row.fronts) {
            track.push_back(fronts->track_ms);
            gradient.push_back(fronts->gradient_ms);
            advect.push_back(fronts->advect_ms);
        }
        if (row.draw_ms) draw.push_back(*row.draw_ms);
        frame.push_back(row.frame_ms);
    }
    return {figures_of("solve", solve),   figures_of("track", track), figures_of("gradient", gradient),
            figures_of("advect", advect), figures_of("draw", draw),   figures_of("frame", frame)};
}

Json PerfLog::to_json() const {
    const auto all = figures();
    const double frame_total = all.back().total;
    Json stages;
    for (const StageFigures& stage : all)
        stages[stage.stage] = {{"count", stage.count},
                               {"mean_ms", stage.mean},
                               {"median_ms", stage.median},
                               {"p95_ms", stage.p95},
                               {"p99_ms", stage.p99},
                               {"max_ms", stage.most},
                               {"share", frame_total > 0 ? stage.total / frame_total : 0}};
    const double ticks_per_s = frame_total > 0 ? 1000.0 * static_cast<double>(rows_.size()) / frame_total : 0;
    return {{"compiler", kCompiler},
            {"commit", kCommit},
            {"processor", processor()},
            {"threads", surroundings_.threads},
            {"gl_renderer", surroundings_.gl_renderer},
            {"ticks_per_s", ticks_per_s},
            {"stages", stages},
            {"paper", paper_figures()}};
}

}  // namespace game
