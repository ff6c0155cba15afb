#include "game/bench/scaling.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include <fmt/format.h>

#include "game/analysis/headless.h"
#include "game/bench/memory.h"
#include "game/session/verifier.h"

namespace game {
namespace {

constexpr std::int64_t kTicksBefore = 4;  // to warm up front tracking
constexpr std::int64_t kTicksEach = 15;

// One grid's session, played from moment to moment.
struct Player {
    Session& session;
    const Recording& recording;
    Verifier* verifier;  // null if nothing was recorded on this grid
    Canvas* canvas;      // null if nothing is drawn
    std::string what;

    Outcome<void> play(std::int64_t until_tick, std::vector<PerfRow>* rows) {
        const auto until = Until::after(until_tick);
        Watchers watchers;
        watchers.after_tick = [&](const Session& now) {
            if (rows) {
                PerfRow row = perf_row(now);
                if (canvas) row.ms.add(canvas->draw(now));
                rows->push_back(row);
            }
            if (verifier) verifier->look_at(now);
        };
        if (auto played = play_headless(session, recording.commands, until, watchers, what); !played)
            return tl::unexpected(played.error());
        return {};
    }
};

// The tick at which the study of a moment starts; none if the recording ends too early.
std::optional<std::int64_t> first_tick(const Recording& recording, const MeasureOptions& options,
                                       int seconds) {
    const std::int64_t last = std::min(options.ticks.value_or(recording.last_tick()), recording.last_tick());
    const std::int64_t from =
        std::llrint(seconds / static_cast<double>(recording.header.scenario.params.tick_s));
    if (from + kTicksBefore + kTicksEach > last) return std::nullopt;
    return from;
}

ScalingRow row_of(std::vector<PerfRow> rows) {
    // Treat each tick as a repeat of the same one: the rolling layer changes little in so few.
    std::vector<std::vector<PerfRow>> repeats;
    repeats.reserve(rows.size());
    for (PerfRow& row : rows) repeats.push_back({std::move(row)});
    const PerfRow middle = medians_of(repeats)[0];
    ScalingRow found;
    found.time_s = middle.time_s;
    found.substeps = middle.substeps;
    found.moving = middle.active_cells;
    found.points = middle.points.value_or(0);
    found.ms = middle.ms;
    return found;
}

Outcome<void> measure_grid(const BenchRecording& named, int squares, const BenchPhysics& physics,
                           const MeasureOptions& options, Canvas* canvas, Scaling& scaling) {
    const auto scenario = scenario_of(named.recording, squares, physics, options.memory);
    if (!scenario) return tl::unexpected(scenario.error());
    const bool drawn = canvas && scenario->grid.size() <= kMostFollowed;
    if (drawn)
        if (auto shown = canvas->show(*scenario); !shown) return shown;

    forget_peak();
    const std::size_t before = resident_bytes();
    auto session = Session::begin(*scenario, options.step, std::nullopt);
    if (!session) return tl::unexpected(session.error());
    std::optional<Verifier> verifier;
    if (has_states_of(named.recording, squares, physics))
        verifier.emplace(named.recording), verifier->look_at(*session);
    Player player{*session, named.recording, verifier ? &*verifier : nullptr, drawn ? canvas : nullptr,
                  fmt::format("{} on {} squares", named.name, squares)};
    const std::size_t first_row = scaling.rows.size();
    double bytes = 0;
    for (const int seconds : kScalingSeconds) {
        const auto begins = first_tick(named.recording, options, seconds);
        if (!begins) break;
        const std::int64_t from = *begins;
        std::vector<PerfRow> unused, rows;
        if (auto played = player.play(from, nullptr); !played) return played;
        session->follow_fronts(*scenario, std::numeric_limits<std::size_t>::max());
        if (bytes == 0) bytes = static_cast<double>(peak_bytes()) - static_cast<double>(before);
        if (auto played = player.play(from + kTicksBefore, &unused); !played) return played;
        if (auto played = player.play(from + kTicksBefore + kTicksEach, &rows); !played) return played;
        session->follow_nothing();
        scaling.rows.push_back(row_of(std::move(rows)));
        scaling.rows.back().squares = squares;
        scaling.rows.back().vertices = scenario->grid.size();
    }
    for (std::size_t i = first_row; i < scaling.rows.size(); ++i) scaling.rows[i].session_bytes = bytes;
    if (!verifier) return {};
    const Verdict& verdict = verifier->verdict();
    if (verdict.kind() == Verdict::Kind::kExact) scaling.proof = Proof::kGolden;
    if (verdict.parted) scaling.proof = Proof::kInvalid, scaling.why = *verdict.parted;
    return {};
}

}  // namespace

Outcome<Scaling> measure_scaling(const BenchRecording& recording, std::span<const int> squares,
                                 const BenchPhysics& physics, const MeasureOptions& options, Canvas* canvas) {
    if (!first_tick(recording.recording, options, kScalingSeconds.front()))
        return unusable(fmt::format("{} ends before second {}, where the study starts", recording.name,
                                    kScalingSeconds.front()));
    Scaling scaling;
    scaling.recording = recording.name;
    scaling.file_hash = recording.file_hash;
    scaling.physics = physics.name;
    scaling.ticks_each = static_cast<int>(kTicksEach);
    for (const int each : squares)
        if (auto measured = measure_grid(recording, each, physics, options, canvas, scaling); !measured)
            return tl::unexpected(measured.error());
    return scaling;
}

std::vector<Exponents> exponents_of(std::span<const ScalingRow> rows) {
    std::vector<double> vertices, points;
    for (const ScalingRow& row : rows) {
        vertices.push_back(static_cast<double>(row.vertices));
        points.push_back(static_cast<double>(row.points));
    }
    const auto fit = [&](std::string part, const std::vector<double>& costs) {
        const std::vector<std::vector<double>> by_vertices{vertices}, by_points{points},
            by_both{vertices, points};
        return Exponents{std::move(part), fit_power_law(costs, by_vertices), fit_power_law(costs, by_points),
                         fit_power_law(costs, by_both)};
    };
    std::vector<Exponents> all;
    for (std::size_t part = 0; part < kPartCount; ++part) {
        std::vector<double> costs;
        for (const ScalingRow& row : rows) costs.push_back(row.ms[part].value_or(0));
        all.push_back(fit(kPartNames[part], costs));
    }
    std::vector<double> ticks;
    for (const ScalingRow& row : rows) ticks.push_back(row.ms.tick());
    all.push_back(fit("tick", ticks));
    return all;
}

}  // namespace game
