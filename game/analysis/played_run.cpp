#include "game/analysis/played_run.h"

#include <utility>

#include <fmt/format.h>

#include "game/recording/command_source.h"
#include "game/recording/recording_file.h"

namespace game {
namespace {

// The tick from which the times of a run count: that of the user's first command, or 0 in a challenge with events,
// which happen at the same ticks in every try.
std::int64_t beginning_of(const Recording& recording) {
    const bool has_events = !recording.header.scenario.goal->events.empty();
    return has_events || recording.commands.empty() ? 0 : recording.commands.front().tick;
}

}  // namespace

Outcome<PlayedRun> play_run(const std::filesystem::path& file, const std::string& challenge,
                            const Memory& memory, const std::atomic<bool>& stopped) {
    const auto recording = read_recording(file, memory);
    if (!recording) return tl::unexpected(recording.error());
    const Scenario& scenario = recording->header.scenario;
    if (!scenario.goal || challenge_id(scenario) != challenge)
        return unusable(fmt::format("{}: is not of this challenge", file.string()));
    auto session = Session::begin(scenario, {.threads = 1}, std::nullopt);
    if (!session) return tl::unexpected(session.error());
    RunExtent extent(scenario.grid, beginning_of(*recording));
    Referee referee(scenario, recording->commands);
    CommandSource source;
    extent.see(session->state());
    while (session->state().tick < recording->last_tick()) {
        if (stopped) return unusable(fmt::format("{}: was not played to its end", file.string()));
        if (auto advanced = session->advance(source.due(session->state(), recording->commands)); !advanced)
            return tl::unexpected(advanced.error());
        extent.see(session->state());
        referee.see(*session);
    }
    auto score = referee.decide();
    if (!score)
        return tl::unexpected(
            Failure{score.error().status, fmt::format("{}: {}", file.string(), score.error().sentence)});
    return PlayedRun{std::move(*score), std::move(extent)};
}

PlayedRuns play_best_run(const std::vector<BestRun>& runs, const std::string& challenge, const Memory& memory,
                         const std::atomic<bool>& stopped) {
    PlayedRuns found;
    for (const BestRun& run : runs) {
        auto played = play_run(run.file, challenge, memory, stopped);
        if (stopped) return {};
        if (!played) {
            found.faults.push_back(played.error().sentence);
        } else if (played->score.points != run.score || played->score.medal != run.medal) {
            found.faults.push_back(fmt::format(
                "{}: its name claims a score of {} ({}); its commands give {} ({})", run.file.string(),
                run.score, medal_name(run.medal), played->score.points, medal_name(played->score.medal)));
        } else {
            found.best = std::move(*played);
            break;
        }
    }
    return found;
}

}  // namespace game
