#include "game/headless.h"

#include <chrono>
#include <vector>

#include <fmt/format.h>

#include "game/progress.h"
#include "sim/front/remesh_reference.h"
#include "sim/step.h"

namespace game {
namespace {

PerfRow perf_row(const Session& session, std::optional<double> draw_ms, double frame_ms) {
    const sim::State& state = session.state();
    const sim::Ledger& mass = state.ledger;
    PerfRow row;
    row.tick = state.tick;
    row.time_s = session.seconds();
    row.substeps = sim::substeps_of(state).count;
    row.solve_ms = session.times().solve_ms;
    if (const auto* fronts = session.fronts()) {
        const TickTimes& times = session.times();
        row.fronts = {times.track_ms, times.gradient_ms, times.advect_ms, fronts->tracker().points().size(),
                      static_cast<std::size_t>(sim::front::count_cut_triangles(fronts->tracker()))};
    }
    row.draw_ms = draw_ms;
    row.frame_ms = frame_ms;
    row.active_cells = session.active_cells();
    row.standing_m3 = session.cubic_metres(mass.standing);
    row.rolling_m3 = session.cubic_metres(mass.rolling);
    row.out_m3 = session.cubic_metres(mass.out);
    row.error_m3 = session.cubic_metres(mass.mass_error());
    row.state_hash = session.state_line().hash;
    return row;
}

std::string picture_name(std::int64_t tick) {
    return fmt::format("tick_{:06}", tick);
}

void report(Progress& progress, const Session& session, const Until& until) {
    const std::int64_t tick = session.state().tick;
    const double share =
        until.tick ? static_cast<double>(tick) / static_cast<double>(std::max<std::int64_t>(*until.tick, 1))
                   : -1;
    progress.show(share, fmt::format("{:.1f} s, {:.0f} m3 moving", session.seconds(),
                                     session.cubic_metres(session.state().ledger.rolling)));
}

}  // namespace

Outcome<bool> play_headless(Session& session, std::span<const TimedCommand> commands, const Until& until,
                            const Watchers& watchers, const std::string& what) {
    Progress progress(what);
    std::vector<sim::Command> due;
    std::size_t next = 0;
    const auto done = [&] {
        const std::int64_t tick = session.state().tick;
        return (until.tick && tick >= *until.tick) ||
               (until.rest && tick > 0 && next == commands.size() && sim::at_rest(session.state()));
    };
    const auto draw = [&] {
        return watchers.gallery->draw(session.view(), session.fronts(), picture_name(session.state().tick));
    };

    if (watchers.gallery) draw();
    while (!done()) {
        const std::int64_t tick = session.state().tick;
        if (tick >= until.most_ticks) return false;

        due.clear();
        for (; next < commands.size() && commands[next].tick == tick; ++next)
            due.push_back(commands[next].command);

        const auto before = std::chrono::steady_clock::now();
        if (auto advanced = session.advance(due); !advanced) return tl::unexpected(advanced.error());
        std::optional<double> draw_ms;
        const bool last = done();
        if (watchers.gallery && (last || (tick + 1) % watchers.ticks_per_picture == 0)) draw_ms = draw();
        const std::chrono::duration<double, std::milli> frame = std::chrono::steady_clock::now() - before;

        if (watchers.perf) watchers.perf->add(perf_row(session, draw_ms, frame.count()));
        if (watchers.after_tick) watchers.after_tick(session);
        report(progress, session, until);
    }
    return true;
}

}  // namespace game
