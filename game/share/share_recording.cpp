#include "game/share/share_recording.h"

#include <algorithm>
#include <cctype>
#include <vector>

#include <fmt/format.h>

#include "game/analysis/best_runs.h"
#include "game/analysis/headless.h"
#include "game/files/assets.h"
#include "game/recording/command_source.h"
#include "game/recording/recording_file.h"
#include "game/scene/shipped_look.h"
#include "game/session/session.h"

namespace game {

std::string proof_of(const std::filesystem::path& recording) {
    const bool shipped = is_asset(AssetKind::kRecording, recording.string());
    std::string name = shipped ? recording.string() : recording.filename().string();
    const bool plain = std::all_of(name.begin(), name.end(), [](unsigned char c) {
        return std::isalnum(c) || c == '-' || c == '_' || c == '.';
    });
    if (!plain) {  // as a shell reads it
        for (std::size_t at = 0; (at = name.find('\'', at)) != name.npos; at += 4)
            name.replace(at, 1, "'\\''");
        name = "'" + name + "'";
    }
    return fmt::format("couloir replay {} --verify", name);
}

Outcome<PageReport> write_page_of(const std::filesystem::path& recording, const std::filesystem::path& page,
                                  const PageOptions& options, const std::atomic<bool>* stop,
                                  std::atomic<float>* progress) {
    auto read = read_recording(recording);
    if (!read) return tl::unexpected(read.error());
    if (auto taken = take_look(LookFrom::kShipped, read->header.scenario); !taken)
        return tl::unexpected(taken.error());
    const Scenario& scenario = read->header.scenario;
    auto session = Session::begin(scenario, {}, std::nullopt);
    if (!session) return tl::unexpected(session.error());
    session->follow_powder(scenario);
    auto slide = SlidePage::begin(scenario, *session, proof_of(recording), options);
    if (!slide) return tl::unexpected(slide.error());

    CommandSource source;
    const std::int64_t last = read->last_tick();
    for (std::int64_t tick = 0; tick < last; ++tick) {
        if (stop && stop->load())
            return machine_fails(fmt::format("{}: stopped before its end", page.string()));
        if (progress) progress->store(static_cast<float>(tick) / static_cast<float>(last));
        if (auto advanced = session->advance(source.due(session->state(), read->commands)); !advanced)
            return tl::unexpected(advanced.error());
        if (auto seen = slide->see(*session); !seen) return tl::unexpected(seen.error());
    }
    return slide->write(page, *session, read->commands);
}

Outcome<PageReport> write_page_of_loaded(const LoadedWorld& world, const std::filesystem::path& page,
                                         PageOptions options) {
    if (world.watched) return write_page_of(world.scene.files.front(), page, options, nullptr, nullptr);
    const Scenario& scenario = world.scene.scenario;
    if (scenario.goal) {
        if (options.plays && std::ranges::any_of(scenario.goal->tools, [](const Goal::Tool& tool) {
                return tool.kind == sim::CommandKind::kPlant;
            }))
            return unusable(
                fmt::format("--web: {} is won by planting, for which a page has no tool yet; --watch-only "
                            "leaves the world out",
                            scenario.scene));
        if (const auto folder = best_runs_folder(scenario))
            if (const auto runs = best_runs(*folder); !runs.empty()) options.to_beat = runs.front().score;
    }
    auto session = Session::begin(scenario, {}, std::nullopt);
    if (!session) return tl::unexpected(session.error());
    session->follow_powder(scenario);
    auto slide = SlidePage::begin(scenario, *session, "", options);
    if (!slide) return tl::unexpected(slide.error());
    const std::vector<TimedCommand> commands =
        scenario.goal ? std::vector<TimedCommand>() : world.scene.commands;
    if (!commands.empty()) {
        Until until;
        until.rest = Until::Rest::kEnergy;
        Watchers watchers;
        watchers.keep = [&](const Session& now) { return slide->see(now); };
        if (const auto ended = play_headless(*session, commands, until, watchers, scenario.scene); !ended)
            return tl::unexpected(ended.error());
    }
    return slide->write(page, *session, commands);
}

}  // namespace game
