#include "game/session/perf_log.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <thread>

#include <fmt/format.h>

#include "game/base/version.h"
#include "game/files/text_file.h"
#include "sim/front/remesh_reference.h"
#include "sim/step.h"

namespace game {
namespace {

std::string processor() {
    std::ifstream info("/proc/cpuinfo");
    std::string model = "unknown";
    for (std::string line; std::getline(info, line);)
        if (line.rfind("model name", 0) == 0) model = line.substr(std::min(line.size(), line.find(':') + 2));
    return fmt::format("{}, {} cores", model, std::thread::hardware_concurrency());
}

std::string count_or_none(const std::optional<std::size_t>& count) {
    return count ? fmt::to_string(*count) : "";
}

Json paper_figures() {
    Json json;
    for (const PaperScene& scene : kPaperScenes)
        json[scene.name] = {{"frames_per_s", scene.frames_per_s}, {"solve_share", scene.solve_share}};
    return json;
}

}  // namespace

double PartTimes::tick() const {
    double ms = 0;
    for (std::size_t i = 0; i < kTickParts; ++i) ms += (*this)[i].value_or(0);
    return ms;
}

double PartTimes::sum() const {
    double ms = 0;
    for (const auto& part : *this) ms += part.value_or(0);
    return ms;
}

void PartTimes::add(const render::DrawTimes& times) {
    (*this)(Part::kUpload) = times(render::Pass::kUpload);
    (*this)(Part::kRemesh) = times(render::Pass::kRemesh);
    (*this)(Part::kDraw) = times.draw_ms();
    passes = times;
}

PerfRow perf_row(const Session& session) {
    const sim::State& state = session.state();
    const TickTimes& times = session.times();
    PerfRow row;
    row.tick = state.tick;
    row.time_s = session.seconds();
    row.substeps = sim::substeps_of(state).count;
    row.ms(Part::kSolve) = times.solve_ms;
    row.ms(Part::kPeaks) = times.peaks_ms;
    if (const auto* fronts = session.fronts()) {
        row.ms(Part::kTrack) = times.track_ms;
        row.ms(Part::kAdvect) = times.advect_ms;
        row.ms(Part::kGradient) = times.gradient_ms;
        row.points = fronts->tracker().points().size();
    }
    row.state_hash = session.state_line().hash;
    row.ms(Part::kHash) = times.hash_ms;
    row.active_cells = session.active_cells();
    row.standing_m3 = session.cubic_metres(state.ledger.standing);
    row.rolling_m3 = session.cubic_metres(state.ledger.rolling);
    row.out_m3 = session.cubic_metres(state.ledger.out);
    row.error_m3 = session.cubic_metres(state.ledger.mass_error());
    return row;
}

std::optional<std::size_t> cut_triangles(const Session& session) {
    if (!session.fronts()) return std::nullopt;
    return static_cast<std::size_t>(sim::front::count_cut_triangles(session.fronts()->tracker()));
}

std::string to_text(const PerfSurroundings& around) {
    const auto& by = around.drawn;
    const std::string drawn = by ? fmt::format("{}; quality: {}; drawing timed by {}", by->renderer,
                                               by->quality, render::to_string(by->timing))
                                 : "none, nothing was drawn";
    return fmt::format("# {}, commit {}\n# {}\n# processor: {}; threads: {}\n# GL: {}\n# of: {}{}\n",
                       kProgram, kCommit, kCompiler, processor(), around.threads, drawn, around.what,
                       around.file_hash.empty() ? "" : ", file hash " + around.file_hash);
}

Json to_json(const PerfSurroundings& around) {
    const render::DrawnBy by = around.drawn.value_or(render::DrawnBy{});
    return {{"program", kProgram},       {"compiler", kCompiler},
            {"commit", kCommit},         {"processor", processor()},
            {"threads", around.threads}, {"gl_renderer", by.renderer},
            {"quality", by.quality},     {"drawing_timed_by", render::to_string(by.timing)}};
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

void StageDigest::add(double ms) {
    const double bucket = std::floor(std::log(std::max(ms, kLeastMs) / kLeastMs) / std::log(kRatio));
    ++in_bucket_[static_cast<std::size_t>(std::min(bucket, static_cast<double>(kBuckets - 1)))];
    least_ = count_ == 0 ? ms : std::min(least_, ms);
    most_ = count_ == 0 ? ms : std::max(most_, ms);
    ++count_;
    total_ += ms;
}

// Nearest rank, as figures_of() has it: the middle of its bucket.
double StageDigest::rank(double share) const {
    const auto wanted = static_cast<std::uint64_t>(std::ceil(share * static_cast<double>(count_)));
    std::uint64_t below = 0;
    for (std::size_t i = 0; i < kBuckets; ++i) {
        below += in_bucket_[i];
        if (below >= wanted)
            return std::clamp(kLeastMs * std::pow(kRatio, static_cast<double>(i) + 0.5), least_, most_);
    }
    return most_;
}

StageFigures StageDigest::figures(std::string stage) const {
    StageFigures figures{std::move(stage), count_};
    if (count_ == 0) return figures;
    figures.total = total_;
    figures.mean = total_ / static_cast<double>(count_);
    figures.median = rank(0.5);
    figures.p95 = rank(0.95);
    figures.p99 = rank(0.99);
    figures.most = most_;
    return figures;
}

std::vector<StageFigures> figures_of(std::span<const PerfRow> rows) {
    std::vector<StageFigures> figures;
    for (std::size_t part = 0; part < kPartCount; ++part) {
        std::vector<double> ms;
        for (const PerfRow& row : rows)
            if (row.ms[part]) ms.push_back(*row.ms[part]);
        figures.push_back(figures_of(kPartNames[part], std::move(ms)));
    }
    std::vector<double> frame;
    for (const PerfRow& row : rows) frame.push_back(row.frame_ms);
    figures.push_back(figures_of("frame", std::move(frame)));
    return figures;
}

Json to_json(std::span<const StageFigures> figures, double whole_ms) {
    Json stages;
    for (const StageFigures& stage : figures)
        stages[stage.stage] = {{"count", stage.count},
                               {"mean_ms", stage.mean},
                               {"median_ms", stage.median},
                               {"p95_ms", stage.p95},
                               {"p99_ms", stage.p99},
                               {"max_ms", stage.most},
                               {"share", whole_ms > 0 ? stage.total / whole_ms : 0}};
    return stages;
}

std::string perf_columns() {
    std::string columns = "frame,tick,time_s,substeps,solve_ms,track_ms,gradient_ms,advect_ms,";
    for (const char* pass : render::kPassNames) columns += fmt::format("{}_ms,", pass);
    return columns +
           "draw_ms,frame_ms,active_cells,discontinuity_points,cut_triangles,mass_standing_m3,"
           "mass_rolling_m3,mass_out_m3,mass_error_m3,state_hash";
}

std::string csv_line(std::size_t frame, const PerfRow& row) {
    std::string parts;
    const auto add = [&](const std::optional<double>& ms) {
        parts += ms ? fmt::format("{:.4f},", *ms) : ",";
    };
    for (const Part part : {Part::kSolve, Part::kTrack, Part::kGradient, Part::kAdvect}) add(row.ms(part));
    for (std::size_t pass = 0; pass < render::kPassCount; ++pass)
        add(row.ms.passes ? std::optional(row.ms.passes->ms[pass]) : std::nullopt);
    add(row.ms(Part::kDraw));
    return fmt::format("{},{},{:.4f},{},{}{:.4f},{},{},{},{:.4f},{:.4f},{:.4f},{:.4f},{}", frame, row.tick,
                       row.time_s, row.substeps, parts, row.frame_ms, row.active_cells,
                       count_or_none(row.points), count_or_none(row.cut_triangles), row.standing_m3,
                       row.rolling_m3, row.out_m3, row.error_m3, hex(row.state_hash));
}

void PerfLog::add(const PerfRow& row) {
    ++ticks_;
    if (keeps_ == Keeps::kRows) return rows_.push_back(row);
    for (std::size_t part = 0; part < kPartCount; ++part)
        if (row.ms[part]) digests_[part].add(*row.ms[part]);
    digests_.back().add(row.frame_ms);
}

std::vector<StageFigures> PerfLog::figures() const {
    if (keeps_ == Keeps::kRows) return figures_of(rows_);
    std::vector<StageFigures> figures;
    for (std::size_t part = 0; part < kPartCount; ++part)
        figures.push_back(digests_[part].figures(kPartNames[part]));
    figures.push_back(digests_.back().figures("frame"));
    return figures;
}

Outcome<void> PerfLog::write_csv(const std::filesystem::path& path) const {
    std::string text = to_text(surroundings_);
    text += perf_columns() + "\n";
    for (std::size_t i = 0; i < rows_.size(); ++i) text += csv_line(i, rows_[i]) + "\n";
    return write_text(path, text);
}

Json PerfLog::to_json() const {
    const auto all = figures();
    const double frame_total = all.back().total;
    Json json = game::to_json(surroundings_);
    json["ticks_per_s"] = frame_total > 0 ? 1000.0 * static_cast<double>(ticks_) / frame_total : 0;
    json["stages"] = game::to_json(all, frame_total);
    json["paper"] = paper_figures();
    return json;
}

}  // namespace game
