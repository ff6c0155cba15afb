#include "game/bench/measure.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "game/analysis/headless.h"
#include "game/bench/memory.h"
#include "game/session/verifier.h"

namespace game {
namespace {

constexpr std::int64_t kWarmUpTicks = 60;

// The parts of a run that all repeats share.
struct BenchRun {
    const Scenario& scenario;
    const Recording& recording;
    const MeasureOptions& options;
    Canvas* canvas;
    std::int64_t ticks;
    bool is_recorded;  // the recording has its states

    Outcome<Session> begin() const {
        auto session = Session::begin(scenario, options.step, std::nullopt);
        if (session) session->follow_fronts(scenario);
        if (session) session->follow_powder(scenario);
        if (session) session->follow_carried(scenario);
        return session;
    }
};

// A frame is drawn every so many ticks, and one right before it,
// because recutting costs grow with the ticks since the last frame.
void draw_if_due(const BenchRun& run, const Session& session, PerfRow& row) {
    if (!run.canvas) return;
    const std::int64_t tick = session.state().tick, every = run.options.every;
    if (tick % every == 0)
        row.ms.add(run.canvas->draw(session));
    else if ((tick + 1) % every == 0)
        run.canvas->draw(session);
}

// Runs once before measuring: allocates the session's memory, then the shaders and buffers of a frame.
Outcome<double> warm_up(const BenchRun& run, const std::string& what) {
    forget_peak();
    const std::size_t before = resident_bytes();
    auto session = run.begin();
    if (!session) return tl::unexpected(session.error());
    const auto until = Until::after(std::min(kWarmUpTicks, run.ticks));
    if (auto played = play_headless(*session, run.recording.commands, until, {}, what); !played)
        return tl::unexpected(played.error());
    const double bytes = static_cast<double>(peak_bytes()) - static_cast<double>(before);
    if (run.canvas)
        for (int frame = 0; frame < 2; ++frame) run.canvas->draw(*session);
    return std::max(bytes, 0.0);
}

Outcome<std::vector<PerfRow>> play_once(const BenchRun& run, const std::string& what, Measured& measured) {
    auto session = run.begin();
    if (!session) return tl::unexpected(session.error());
    std::vector<PerfRow> rows;
    rows.reserve(static_cast<std::size_t>(run.ticks));
    Verifier verifier(run.recording);
    if (run.is_recorded) verifier.look_at(*session);
    double begin_ms = 0;
    const auto until = Until::after(run.ticks);
    Watchers watchers;
    watchers.after_tick = [&](const Session& now) {
        PerfRow row = perf_row(now);
        draw_if_due(run, now, row);
        row.begin_ms = begin_ms;
        row.frame_ms = row.ms.sum();
        row.cut_triangles = cut_triangles(now);
        begin_ms += row.frame_ms;
        rows.push_back(row);
        if (run.is_recorded) verifier.look_at(now);
    };
    if (auto played = play_headless(*session, run.recording.commands, until, watchers, what); !played)
        return tl::unexpected(played.error());
    if (verifier.verdict().parted) measured.why = *verifier.verdict().parted;
    measured.proof = verifier.verdict().kind() == Verdict::Kind::kExact ? Proof::kGolden : Proof::kUnverified;
    return rows;
}

// The first tick at which a repeat differs from the first one; none if all agree.
std::optional<std::int64_t> first_parting(std::span<const std::vector<PerfRow>> repeats) {
    for (const auto& rows : repeats)
        for (std::size_t i = 0; i < rows.size(); ++i)
            if (rows[i].state_hash != repeats[0][i].state_hash) return rows[i].tick;
    return std::nullopt;
}

double total_ms(const std::vector<PerfRow>& rows) {
    double ms = 0;
    for (const PerfRow& row : rows) ms += row.ms.tick();
    return ms;
}

}  // namespace

std::string_view to_string(Proof proof) {
    switch (proof) {
        case Proof::kGolden:
            return "golden";
        case Proof::kUnverified:
            return "unverified";
        case Proof::kInvalid:
            break;
    }
    return "INVALID";
}

Outcome<Measured> measure(const BenchRecording& named, int squares, const BenchPhysics& physics,
                          const MeasureOptions& options, Canvas* canvas, const std::string& what) {
    const Recording& recording = named.recording;
    const auto scenario = scenario_of(recording, squares, physics, options.memory);
    if (!scenario) return tl::unexpected(scenario.error());
    const std::int64_t last = recording.last_tick();
    const BenchRun run{*scenario,
                       recording,
                       options,
                       canvas,
                       std::min(options.ticks.value_or(last), last),
                       has_states_of(recording, squares, physics)};
    if (canvas)
        if (auto shown = canvas->show(*scenario); !shown) return tl::unexpected(shown.error());

    Measured measured{named.name,
                      named.file_hash,
                      std::string(physics.name),
                      squares,
                      scenario->grid,
                      static_cast<double>(scenario->params.tick_s),
                      options.repeats,
                      {},
                      {},
                      Proof::kInvalid,
                      "",
                      0,
                      0,
                      1};
    const auto bytes = warm_up(run, what + ", warming up");
    if (!bytes) return tl::unexpected(bytes.error());
    measured.session_bytes = *bytes;
    std::vector<std::vector<PerfRow>> repeats;
    for (int i = 0; i < options.repeats; ++i) {
        auto rows = play_once(run, fmt::format("{}, {} of {}", what, i + 1, options.repeats), measured);
        if (!rows) return tl::unexpected(rows.error());
        repeats.push_back(std::move(*rows));
    }
    measured.peak_bytes = peak_bytes();
    if (const auto tick = first_parting(repeats); tick && measured.why.empty())
        measured.why = fmt::format("its repeats differ at tick {}", *tick);
    if (!measured.why.empty()) measured.proof = Proof::kInvalid;
    std::vector<double> totals;
    totals.reserve(repeats.size());
    for (const auto& rows : repeats) totals.push_back(total_ms(rows));
    const auto [fastest, slowest] = std::minmax_element(totals.begin(), totals.end());
    if (*fastest > 0) measured.slowest_by_fastest = *slowest / *fastest;
    measured.rows = medians_of(repeats);
    measured.last = std::move(repeats.back());
    return measured;
}

double median_of(std::vector<double> values) {
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>((values.size() - 1) / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

std::vector<PerfRow> medians_of(std::span<const std::vector<PerfRow>> repeats) {
    std::vector<PerfRow> rows = repeats[0];
    double begin_ms = 0;
    for (std::size_t i = 0; i < rows.size(); ++i) {
        for (std::size_t part = 0; part < kPartCount; ++part) {
            if (!rows[i].ms[part]) continue;
            std::vector<double> ms;
            for (const auto& repeat : repeats) ms.push_back(*repeat[i].ms[part]);
            rows[i].ms[part] = median_of(std::move(ms));
        }
        if (rows[i].ms.passes)
            for (std::size_t pass = 0; pass < render::kPassCount; ++pass) {
                std::vector<double> ms;
                for (const auto& repeat : repeats) ms.push_back(repeat[i].ms.passes->ms[pass]);
                rows[i].ms.passes->ms[pass] = median_of(std::move(ms));
            }
        rows[i].frame_ms = rows[i].ms.sum();
        rows[i].begin_ms = begin_ms;
        begin_ms += rows[i].frame_ms;
    }
    return rows;
}

FrameFigures frame_figures(const Measured& measured) {
    FrameFigures figures;
    const auto& rows = measured.rows;
    const auto parts = figures_of(rows);
    std::copy_n(parts.begin(), kPartCount, figures.parts.begin());
    const bool any_drawn =
        std::any_of(rows.begin(), rows.end(), [](const PerfRow& r) { return r.ms.drawn(); });
    std::size_t most_active = 0;
    std::vector<double> tick, frame;
    for (const PerfRow& row : rows) {
        tick.push_back(row.ms.tick());
        if (row.ms.drawn() || !any_drawn) frame.push_back(row.frame_ms);
        most_active = std::max(most_active, row.active_cells);
    }
    figures.slow =
        frame.empty()
            ? 0
            : static_cast<double>(std::count_if(frame.begin(), frame.end(),
                                                [&](double ms) { return ms > 1000 * measured.tick_s; })) /
                  static_cast<double>(frame.size());
    figures.tick = figures_of("tick", std::move(tick));
    figures.frame = figures_of("frame", std::move(frame));
    figures.frame_ms = figures.tick.mean;
    for (std::size_t part = kTickParts; part < kPartCount; ++part)
        figures.frame_ms += figures.parts[part].mean;

    const double drawing = figures.frame_ms - figures.tick.mean;
    double fronts = 0, all = 0;
    for (const PerfRow& row : rows) {
        if (4 * row.active_cells < 3 * most_active) continue;
        for (const Part part : {Part::kTrack, Part::kAdvect, Part::kGradient})
            fronts += row.ms(part).value_or(0);
        all += row.ms.tick() + drawing;
    }
    figures.busy_fronts = all > 0 ? fronts / all : 0;
    return figures;
}

}  // namespace game
