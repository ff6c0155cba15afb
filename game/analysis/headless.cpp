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

std::string_view to_string(Ended ended) {
    switch (ended) {
        case Ended::kTick:
            return "time";
        case Ended::kEnergy:
            return "energy";
        case Ended::kStill:
            return "rest";
        case Ended::kLimit:
            break;
    }
    return "limit";
}

std::vector<sim::Command> commands_of_tick(std::span<const TimedCommand> commands, std::int64_t tick) {
    std::vector<sim::Command> due;
    for (const TimedCommand& each : commands_at(commands, tick)) due.push_back(each.command);
    return due;
}

Outcome<Ended> play_headless(Session& session, std::span<const TimedCommand> commands, const Until& until,
                             const Watchers& watchers, const std::string& what) {
    Progress progress(what);
    CommandSource source;
    std::int64_t greatest_energy = 0;  // since the last command
    const auto ended = [&]() -> std::optional<Ended> {
        const sim::State& state = session.state();
        if (until.tick && state.tick >= *until.tick) return Ended::kTick;
        if (until.rest == Until::Rest::kNone || state.tick == 0 ||
            !commands_from(commands, state.tick).empty())
            return std::nullopt;
        if (sim::at_rest(state)) return Ended::kStill;
        const bool is_last_flow =
            !state.weather || state.weather->is_over();  // else the calendar continues after it
        const bool may_end = until.rest == Until::Rest::kEnergy && is_last_flow &&
                             state.running_commands.empty() && !session.is_in_try();
        if (may_end && session.energy() < greatest_energy / Until::kEnergyFallsBy) return Ended::kEnergy;
        return std::nullopt;
    };
    const auto draw = [&]() -> render::DrawTimes {
        return watchers.gallery->draw(session, picture_name(session.state().tick));
    };

    using Clock = std::chrono::steady_clock;
    using Milliseconds = std::chrono::duration<double, std::milli>;
    const auto began = Clock::now();
    if (watchers.gallery) draw();
    std::optional<Ended> end = ended();
    while (!end) {
        const std::int64_t tick = session.state().tick;
        if (tick >= until.most_ticks) return Ended::kLimit;

        const auto before = Clock::now();
        const std::span<const sim::Command> due = source.due(session.state(), commands);
        if (auto advanced = session.advance(due); !advanced) return tl::unexpected(advanced.error());
        greatest_energy = due.empty() ? std::max(greatest_energy, session.energy()) : session.energy();
        end = ended();
        std::optional<PerfRow> row;
        if (watchers.perf) row = perf_row(session);
        if (watchers.gallery && (end || (tick + 1) % watchers.ticks_per_picture == 0)) {
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
    return *end;
}

}  // namespace game
