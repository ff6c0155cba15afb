#include "game/share/share_recording.h"

#include <algorithm>
#include <cctype>
#include <memory>
#include <optional>
#include <vector>

#include <fmt/format.h>

#include "game/analysis/best_runs.h"
#include "game/analysis/headless.h"
#include "game/analysis/played_run.h"
#include "game/files/assets.h"
#include "game/files/text_file.h"
#include "game/recording/recording_file.h"
#include "game/scene/shipped_look.h"
#include "game/session/session.h"
#include "game/share/page_lesson.h"

namespace game {

namespace {

// Of a challenge in which nothing was done yet: asks to beat the best run on this machine, which is played again, and left out
// if its score is not what it claims.
void prepare_challenge(const Scenario& scenario, const Memory& memory, const std::atomic<bool>* stop,
                       PageOptions& options, std::vector<std::string>& notices) {
    const auto folder = best_runs_folder(scenario);
    if (!folder) return;
    const std::atomic<bool> never = false;
    PlayedRuns played =
        play_best_run(best_runs(*folder), challenge_id(scenario), memory, stop ? *stop : never);
    if (played.best) options.to_beat = std::make_shared<const PlayedRun>(std::move(*played.best));
    for (const std::string& fault : played.faults)
        notices.push_back(fmt::format("A best run is not in the page: {}", fault));
}

Outcome<MadePage> with(Outcome<MadePage> page, std::vector<std::string> notices) {
    if (page) page->report.notices = std::move(notices);
    return page;
}

Outcome<MadePage> make_page_of(const std::filesystem::path& recording, PageOptions options,
                               const std::atomic<bool>* stop, std::atomic<float>* progress) {
    auto read = read_recording(recording);
    if (!read) return tl::unexpected(read.error());
    if (auto taken = take_look(LookFrom::kShipped, read->header.scenario); !taken)
        return tl::unexpected(taken.error());
    const Scenario& scenario = read->header.scenario;
    std::vector<std::string> notices;
    if (scenario.goal && is_world(*read)) prepare_challenge(scenario, {}, stop, options, notices);
    auto session = Session::begin(scenario, {}, std::nullopt);
    if (!session) return tl::unexpected(session.error());
    session->follow_powder(scenario);
    auto slide = SlidePage::begin(scenario, *session, proof_of(recording), options);
    if (!slide) return tl::unexpected(slide.error());

    // It ends with its slide, whatever was recorded of the time after that; a try has its own end, and a lesson its last stop.
    const std::int64_t last = read->last_tick();
    Until until = Until::after(last);
    if (!scenario.goal && !options.lesson) until.rest = Until::Rest::kEnergy;
    std::optional<PageLesson> lesson;
    if (options.lesson)
        lesson.emplace(*options.lesson, static_cast<double>(scenario.params.tick_s), read->commands);
    if (lesson) lesson->see(scenario, *session);
    Watchers watchers;
    watchers.keep = [&](const Session& now) -> Outcome<void> {
        if (stop && stop->load())
            return machine_fails(fmt::format("{}: stopped before its end", recording.string()));
        if (progress) progress->store(static_cast<float>(now.state().tick) / static_cast<float>(last));
        if (lesson) lesson->see(scenario, now);
        return slide->see(now);
    };
    if (const auto ended = play_headless(*session, read->commands, until, watchers, ""); !ended)
        return tl::unexpected(ended.error());
    if (lesson) slide->set_lesson(lesson->json());
    return with(slide->make(*session, read->commands), std::move(notices));
}

Outcome<PageReport> write(const std::filesystem::path& file, Outcome<MadePage> page) {
    if (!page) return tl::unexpected(page.error());
    if (auto written = write_text(file, page->text); !written) return tl::unexpected(written.error());
    return std::move(page->report);
}

}  // namespace

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

Outcome<MadePage> make_page_of_loaded(const LoadedWorld& world, PageOptions options) {
    if (world.lesson) options.lesson = std::make_shared<const Lesson>(*world.lesson);
    if (world.watched) return make_page_of(world.scene.files.front(), options, nullptr, nullptr);
    const Scenario& scenario = world.scene.scenario;
    std::vector<std::string> notices;
    if (scenario.goal) prepare_challenge(scenario, world.memory, nullptr, options, notices);
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
    return with(slide->make(*session, commands), std::move(notices));
}

Outcome<PageReport> write_page_of(const std::filesystem::path& recording, const std::filesystem::path& page,
                                  PageOptions options, const std::atomic<bool>* stop,
                                  std::atomic<float>* progress) {
    return write(page, make_page_of(recording, std::move(options), stop, progress));
}

Outcome<PageReport> write_page_of_loaded(const LoadedWorld& world, const std::filesystem::path& page,
                                         PageOptions options) {
    return write(page, make_page_of_loaded(world, std::move(options)));
}

}  // namespace game
