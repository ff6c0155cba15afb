#include "game/analysis/headless.h"

#include <algorithm>
#include <chrono>

#include <fmt/format.h>

#include "game/base/progress.h"
#include "game/recording/command_source.h"

namespace game {
namespace {

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
    CommandSource source;
    const auto done = [&] {
        const std::int64_t tick = session.state().tick;
        return (until.tick && tick >= *until.tick) ||
               (until.rest && tick > 0 && commands_from(commands, tick).empty() &&
                sim::at_rest(session.state()));
    };
    const auto draw = [&]() -> render::DrawTimes {
        return watchers.gallery->draw(session, picture_name(session.state().tick));
    };

    using Clock = std::chrono::steady_clock;
    using Milliseconds = std::chrono::duration<double, std::milli>;
    const auto began = Clock::now();
    if (watchers.gallery) draw();
    while (!done()) {
        const std::int64_t tick = session.state().tick;
        if (tick >= until.most_ticks) return false;

        const auto before = Clock::now();
        if (auto advanced = session.advance(source.due(session.state(), commands)); !advanced)
            return tl::unexpected(advanced.error());
        std::optional<PerfRow> row;
        if (watchers.perf) row = perf_row(session);
        if (watchers.gallery && (done() || (tick + 1) % watchers.ticks_per_picture == 0)) {
            const render::DrawTimes times = draw();
            if (row) row->ms.add(times);
        }
        if (row) {
            row->begin_ms = Milliseconds(before - began).count();
            row->frame_ms = Milliseconds(Clock::now() - before).count();
            row->cut_triangles = cut_triangles(session);
            watchers.perf->add(*row);
        }
        if (watchers.after_tick) watchers.after_tick(session);
        if (watchers.keep)
            if (auto kept = watchers.keep(session); !kept) return tl::unexpected(kept.error());
        report(progress, session, until);
    }
    return true;
}

}  // namespace game
