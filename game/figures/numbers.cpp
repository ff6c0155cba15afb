#include "game/figures/numbers.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <mutex>
#include <thread>

#include <fmt/format.h>

#include "game/base/progress.h"
#include "game/figures/level_flow.h"

namespace game {
namespace {

using sim::fields::Cutting;
using sim::fields::FrontScore;
using sim::fields::TestFlow;
using sim::fields::TextureScore;
using sim::front::PointSource;

constexpr std::array kSources{PointSource::kHalf, PointSource::kPaper, PointSource::kFit};
constexpr std::size_t kFit = 2, kSmoothAlone = 0, kReseeded = 3;
constexpr double kSmooth = 0.03;   // m/s, on top of the velocity that advects textures
constexpr double kAsSmooth = 1.1;  // times the stretch by the smooth field alone
// Limits of textures that travel: see TextureScore.
constexpr double kSlip = 0.05, kSlipNear = 0.10, kDrift = 0.25;

struct Bounds {
    int squares;
    std::array<double, 4> rms;  // of each scene's points by fit, cells
    double stretched;           // of cut and re-seeded textures, the share of all area above 2
};
// As measured (docs/results/front-accuracy.md), plus a margin: a hundredth of a cell, a third of one for the
// coarsest disc; for the share at least a tenth.
constexpr std::array<Bounds, 5> kBounds{{{10, {.112, .050, .086, .197}, .001},
                                         {20, {.076, .036, .066, .099}, .001},
                                         {30, {.072, .032, .062, .063}, .001},
                                         {80, {.069, .035, .049, .054}, .002},
                                         {160, {.115, .047, .059, .071}, .002}}};

const Bounds* bounds_of(int squares) {
    const auto* found = std::find_if(kBounds.begin(), kBounds.end(),
                                     [=](const Bounds& bounds) { return bounds.squares == squares; });
    return found == kBounds.end() ? nullptr : found;
}

// One score of one scene on one grid.
struct Job {
    FlowScores* into;
    std::size_t way;  // first the sources, then the textures

    void run() const {
        const auto cell = 1.f / static_cast<float>(into->squares);
        const auto mesh = sim::front::mesh_of(sim::Grid{into->squares + 1, into->squares + 1, cell});
        const auto rule = sim::front::gradient_rule(kJump, cell);
        TestFlow flow = flow_scenes()[into->scene].flow;
        if (way < kSources.size()) {
            into->front[way] =
                sim::fields::score(mesh, rule, kSources[way], flow, {.cell = 1.0 / into->squares});
            return;
        }
        constexpr std::array kCuttings{Cutting::kNone, Cutting::kNone, Cutting::kToLetter,
                                       Cutting::kReseeded};
        const std::size_t texture = way - kSources.size();
        flow.smooth = kSmooth;
        into->texture[texture] =
            sim::fields::score_texture(mesh, rule, PointSource::kFit, flow, kCuttings[texture],
                                       {.reset_s = 2, .smooth_alone = texture == kSmoothAlone});
    }
    double cost() const { return 1.0 * into->squares * into->squares; }
};

// Runs all jobs on this many threads, the most expensive first, while the caller shows progress.
void run_all(std::vector<Job>& jobs, int threads) {
    std::stable_sort(jobs.begin(), jobs.end(),
                     [](const Job& a, const Job& b) { return a.cost() > b.cost(); });
    double all = 0, done = 0;
    for (const Job& job : jobs) all += job.cost();
    std::atomic<std::size_t> next = 0;
    std::size_t finished = 0;
    std::mutex mutex;  // guards done and finished
    std::condition_variable changed;
    const auto serve = [&] {
        for (std::size_t i = next++; i < jobs.size(); i = next++) {
            jobs[i].run();
            const std::lock_guard lock(mutex);
            done += jobs[i].cost(), ++finished;
            changed.notify_one();
        }
    };
    std::vector<std::jthread> crew;  // joined if the system has no more threads
    crew.reserve(static_cast<std::size_t>(threads));
    for (int i = 0; i < threads; ++i) crew.emplace_back(serve);
    Progress progress("measuring");
    {
        std::unique_lock lock(mutex);
        while (finished < jobs.size()) {
            progress.show(done / all, fmt::format("{} of {} scores", finished, jobs.size()));
            changed.wait(lock);
        }
    }
}

std::string name_of(const FlowScores& row) {
    return fmt::format("{}, {} squares", flow_scenes()[row.scene].title, row.squares);
}

}  // namespace

std::span<const MeasuredFlow> flow_scenes() {
    static const std::array<MeasuredFlow, 4> kScenes{{{"line_45", "line, 45°", sim::fields::swinging(45)},
                                                      {"line_30", "line, 30°", sim::fields::swinging(30)},
                                                      {"pinwheel", "pinwheel", sim::fields::pinwheel()},
                                                      {"disc", "disc", sim::fields::disc()}}};
    return kScenes;
}

std::vector<FlowScores> measure_flows(std::span<const int> squares, int threads) {
    std::vector<FlowScores> numbers;
    for (int scene = 0; scene < static_cast<int>(flow_scenes().size()); ++scene)
        for (const int n : squares) numbers.push_back({scene, n, {}, {}});
    std::vector<Job> jobs;
    for (FlowScores& row : numbers)
        for (std::size_t way = 0; way < row.front.size() + row.texture.size(); ++way)
            jobs.push_back({&row, way});
    run_all(jobs, threads);
    return numbers;
}

std::optional<double> fit_bound(int scene, int squares) {
    if (const Bounds* bounds = bounds_of(squares)) return bounds->rms[scene];
    return std::nullopt;
}

std::optional<std::string> first_miss(std::span<const FlowScores> numbers) {
    for (const FlowScores& row : numbers) {
        const Bounds* bounds = bounds_of(row.squares);
        const double rms = row.front[kFit].rms;
        if (bounds && !(rms <= bounds->rms[row.scene]))
            return fmt::format(
                "{}: the root mean square error of fit is {:.3f} cells, above its limit {:.3f}", name_of(row),
                rms, bounds->rms[row.scene]);
        const TextureScore &reseeded = row.texture[kReseeded], &smooth = row.texture[kSmoothAlone];
        if (!(reseeded.stretch_p95 <= kAsSmooth * smooth.stretch_p95))
            return fmt::format("{}: the stretch of textures near the front is {:.2f}, above its limit {:.2f}",
                               name_of(row), reseeded.stretch_p95, kAsSmooth * smooth.stretch_p95);
        if (bounds && !(reseeded.stretched <= bounds->stretched))
            return fmt::format("{}: {:.2f} % of textures have a stretch above 2; the limit is {:.2f} %",
                               name_of(row), 100 * reseeded.stretched, 100 * bounds->stretched);
        if (bounds && !(reseeded.slip <= kSlip && reseeded.slip_near <= kSlipNear))
            return fmt::format(
                "{}: textures slip by {:.3f} and near the front by {:.3f}; the limits are {:.2f} and {:.2f}",
                name_of(row), reseeded.slip, reseeded.slip_near, kSlip, kSlipNear);
        if (bounds && !(reseeded.drift_p95 <= kDrift))
            return fmt::format("{}: textures lag behind the flow by {:.2f} cells, above the limit {:.2f}",
                               name_of(row), reseeded.drift_p95, kDrift);
    }
    return std::nullopt;
}

std::vector<Table> tables_of(std::span<const FlowScores> numbers) {
    Table near{
        "Distance of the points from the front, in cells: root mean square, and 95 % percentile",
        {"scene", "N", "half", "95 %", "paper", "95 %", "fit", "95 %", "fit limit", "missed %", "false %"},
        {}};
    Table jumps{"Jumps per second: points that move, appear or vanish farther than a front can move",
                {"scene", "N", "half", "paper", "fit", "the front itself", "points"},
                {}};
    Table texture{"Stretch of textures near the front: 95 % percentile, and the share of all above 2",
                  {"scene", "N", "smooth only", "> 2 %", "no cuts", "> 2 %", "as published", "> 2 %",
                   "re-seeded", "> 2 %"},
                  {}};
    Table travel{
        "Advection of cut and re-seeded textures: slip as a share of the distance, and how many "
        "cells 95 % of them lag behind the flow until they are renewed",
        {"scene", "N", "slip", "limit", "near the front", "limit", "lag", "limit"},
        {}};
    for (const FlowScores& row : numbers) {
        const std::vector<std::string> start{flow_scenes()[row.scene].title, fmt::to_string(row.squares)};
        near.rows.push_back(start), jumps.rows.push_back(start);
        texture.rows.push_back(start), travel.rows.push_back(start);
        const auto add = [](Table& table, const std::string& text) { table.rows.back().push_back(text); };
        for (const FrontScore& score : row.front) {
            add(near, fmt::format("{:.3f}", score.rms)), add(near, fmt::format("{:.3f}", score.p95));
            add(jumps, fmt::format("{:.0f}", score.jumps));
        }
        const auto bound = fit_bound(row.scene, row.squares);
        const FrontScore& fit = row.front[kFit];
        add(near, bound ? fmt::format("{:.3f}", *bound) : "");
        add(near, fmt::format("{:.2f}", 100 * fit.missed));
        add(near, fmt::format("{:.2f}", 100 * fit.false_cuts));
        add(jumps, fmt::format("{:.0f}", fit.true_jumps)), add(jumps, fmt::format("{:.0f}", fit.points));
        for (const TextureScore& score : row.texture) {
            add(texture, fmt::format("{:.{}f}", score.stretch_p95, score.stretch_p95 < 100 ? 2 : 0));
            add(texture, fmt::format("{:.2f}", 100 * score.stretched));
        }
        const TextureScore& reseeded = row.texture[kReseeded];
        const double share[][2] = {
            {reseeded.slip, kSlip}, {reseeded.slip_near, kSlipNear}, {reseeded.drift_p95, kDrift}};
        for (const auto& [is, may] : share)
            add(travel, fmt::format("{:.3f}", is)), add(travel, fmt::format("{:.2f}", may));
    }
    return {near, jumps, texture, travel};
}

std::string csv_of(std::span<const FlowScores> numbers) {
    std::string csv = "scene,squares";
    for (const PointSource source : kSources)
        for (const char* what : {"rms_cells", "p95_cells", "jumps_per_s"})
            csv += fmt::format(",{}_{}", to_string(source), what);
    csv += ",true_jumps_per_s,missed_share,false_share,points,fit_rms_bound_cells";
    for (const char* way : {"smooth", "uncut", "letter", "reseeded"})
        csv += fmt::format(",{0}_stretch_p95,{0}_share_above_2", way);
    csv += ",reseeded_slip,reseeded_slip_near,reseeded_drift_p95_cells";
    csv += '\n';
    for (const FlowScores& row : numbers) {
        csv += fmt::format("{},{}", flow_scenes()[row.scene].name, row.squares);
        for (const FrontScore& score : row.front)
            csv += fmt::format(",{:.5f},{:.5f},{:.3f}", score.rms, score.p95, score.jumps);
        const FrontScore& fit = row.front[kFit];
        const auto bound = fit_bound(row.scene, row.squares);
        csv += fmt::format(",{:.3f},{:.6f},{:.6f},{:.2f},{}", fit.true_jumps, fit.missed, fit.false_cuts,
                           fit.points, bound ? fmt::format("{:.3f}", *bound) : "");
        for (const TextureScore& score : row.texture)
            csv += fmt::format(",{:.4f},{:.6f}", score.stretch_p95, score.stretched);
        const TextureScore& reseeded = row.texture[kReseeded];
        csv += fmt::format(",{:.5f},{:.5f},{:.4f}", reseeded.slip, reseeded.slip_near, reseeded.drift_p95);
        csv += '\n';
    }
    return csv;
}

}  // namespace game
