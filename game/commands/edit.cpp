#include <algorithm>

#include <fmt/format.h>

#include "game/commands/commands.h"
#include "game/compare/comparison.h"
#include "game/files/file_use.h"
#include "game/files/text_file.h"
#include "game/recording/command_source.h"
#include "game/recording/recording_file.h"
#include "sim/initial_state.h"

namespace game {
namespace {

// Until nothing moves, if the original ended at rest; in any case until every command was applied.
Until until_as(const Played& old, const std::vector<TimedCommand>& commands) {
    const std::int64_t given = commands.empty() ? 0 : commands.back().tick + 1;
    return old.at_rest ? Until::still(given) : Until::after(std::max(old.session.state().tick, given));
}

}  // namespace

Outcome<int> edit(const EditOptions& options) {
    // Both recordings are played, then run again in lockstep.
    Memory memory = options.memory;
    memory.use = {.sessions = 2, .runs = 2};
    const auto old = open_recording(options.recording, memory);
    if (!old) return tl::unexpected(old.error());
    auto changed = edited(old->recording, options.edit);
    if (!changed) return unusable(fmt::format("{}: {}", options.recording, changed.error().sentence));
    const Scenario& scenario = old->recording.header.scenario;
    if (auto possible =
            check_ahead(sim::make_state(initial_state_of(scenario), scenario.params), changed->commands);
        !possible)
        return unusable(fmt::format("{}: {}", options.recording, possible.error().sentence));
    FileUse use;
    use.reads(old->path).writes("--out", options.out).writes_into("--maps", options.maps, kMapNames);
    if (auto sound = use.check(); !sound) return tl::unexpected(sound.error());
    if (options.maps)
        if (auto made = make_folder(*options.maps); !made) return tl::unexpected(made.error());

    Named made{options.out.stem().string(), options.out, {}};
    made.recording.header.scenario = scenario;
    made.recording.header.parent = Parent{old->name, options.edit.tick, changed->change};
    made.recording.commands = std::move(changed->commands);
    auto recorder = record_into(options.out, made.recording.header, RecordingReplaces::kWhenDone);
    if (!recorder) return tl::unexpected(recorder.error());

    const auto before =
        played(*old, Until::after(old->recording.last_tick()), options.step_options, std::nullopt);
    if (!before) return tl::unexpected(before.error());
    const auto after =
        played(made, until_as(*before, made.recording.commands), options.step_options, std::move(*recorder));
    if (!after) return tl::unexpected(after.error());
    if (auto told = tell(comparison_of(*before, *after, options.step_options), options.maps, options.json);
        !told)
        return tl::unexpected(told.error());
    return 0;
}

}  // namespace game
