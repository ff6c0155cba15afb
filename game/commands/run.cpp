#include <cmath>

#include <fmt/format.h>

#include "game/analysis/export_iseesnow.h"
#include "game/analysis/export_results.h"
#include "game/analysis/headless.h"
#include "game/analysis/measures.h"
#include "game/analysis/summary.h"
#include "game/base/print.h"
#include "game/commands/outputs.h"
#include "game/files/file_use.h"
#include "game/files/text_file.h"
#include "game/recording/command_source.h"
#include "game/recording/recording_file.h"
#include "game/session/world_now.h"
#include "game/share/share_recording.h"
#include "terrains/release.h"

namespace game {
namespace {

Outcome<Scene> scene_of(const RunOptions& options) {
    Overrides overrides = options.overrides;
    Outputs::add_to(overrides.memory.use, options);
    if (!options.terrain) return load_scene(options.scene, overrides);
    return scene_of_terrain(*options.terrain, ReleaseFile{*options.release, options.thickness}, overrides);
}

Outcome<terrains::Reference> reference_of(const RunOptions& options, const Scenario& scenario) {
    if (!options.reference) return terrains::Reference();
    auto reference =
        terrains::read_reference(*options.reference, ground_of(scenario), options.overrides.references);
    if (!reference) return unusable(reference.error());
    return std::move(*reference);
}

FileUse files_of(const RunOptions& options, const Scene& scene, const terrains::Reference& reference) {
    FileUse use;
    use.reads(scene.files).reads(reference.files);
    Outputs::add_to(use, options);
    use.writes("--record", options.record);
    use.writes("--save-world", options.save_world);
    use.writes_into("--export", options.export_folder, options.iseesnow ? kIseesnowNames : kExportedNames);
    use.writes_into("--frames", options.pictures.folder, kFrameNames);
    return use;
}

// Opens the outputs once all that can be refused has been.
Outcome<Outputs> open_outputs(const RunOptions& options, const Scenario& scenario, Session& session) {
    auto outputs =
        Outputs::begin(options, scenario, session, options.record ? proof_of(*options.record) : "");
    if (!outputs) return outputs;
    if (options.export_folder)
        if (auto made = make_folder(*options.export_folder); !made) return tl::unexpected(made.error());
    if (options.save_world)
        if (auto placed = make_place_for(*options.save_world); !placed) return tl::unexpected(placed.error());
    if (auto opened = outputs->open(scenario); !opened) return tl::unexpected(opened.error());
    return outputs;
}

Outcome<void> begin_recording(const RunOptions& options, const Scenario& scenario, Session& session) {
    if (!options.record) return {};
    auto recorder = record_into(*options.record, scenario);
    if (!recorder) return tl::unexpected(recorder.error());
    return session.record_from_start(std::move(*recorder));
}

Until until_of(const RunOptions& options, const sim::Params& params) {
    Until until;
    const auto ticks = [&](double seconds) {
        return std::llrint(seconds / static_cast<double>(params.tick_s));
    };
    if (options.until_rest) until.rest = Until::Rest::kEnergy;
    if (options.until_still) until.rest = Until::Rest::kStill;
    if (until.rest != Until::Rest::kNone)
        until.most_ticks = ticks(options.seconds.value_or(3600));
    else
        until.tick = until.most_ticks = ticks(*options.seconds);
    return until;
}

// Whether more of the release is lost than the user accepts.
bool loses_release(const RunOptions& options, const Scene& scene) {
    return scene.release && scene.release->volumes.much_is_lost() && !options.accept_loss;
}

// Before the work, which may take long.
void tell_warnings(const RunOptions& options, const Scene& scene) {
    for (const std::string& warning : scene.warnings) print_line(stderr, "couloir: {}", warning);
    if (loses_release(options, scene))
        print_line(
            stderr,
            "couloir: {}: over 1 % of the release is lost, see the summary; --accept-loss accepts that",
            options.release->string());
}

// Plays the session, and writes what is wanted of it.
Outcome<int> play_and_write(const RunOptions& options, const Scene& scene,
                            const terrains::Reference& reference, Session& session, Outputs& outputs) {
    const Scenario& scenario = scene.scenario;
    Watchers watchers =
        outputs.watch(scenario, session, {scenario.scene, "", options.step_options.threads, {}});
    Referee referee(scenario, scene.commands);
    if (scenario.goal) watchers.after_tick = [&](const Session& now) { referee.see(now); };
    const auto ended = play_headless(session, scene.commands, until_of(options, scenario.params), watchers,
                                     outputs.doing("running"));
    if (!ended) return tl::unexpected(ended.error());
    if (auto closed = session.end_recording(); !closed) return tl::unexpected(closed.error());

    if (options.save_world) {
        const auto saved = scenario_of_now(scenario, session.state()).and_then([&](const Scenario& now) {
            return write_text(*options.save_world, recording_of(now));
        });
        if (!saved) return tl::unexpected(saved.error());
    }
    const Measures measures = measure(scenario, session, release_area(scenario, scene.commands), reference);
    Summary summary{scenario, session, measures, &outputs.perf(), std::nullopt, std::nullopt};
    summary.ended = *ended;
    if (scene.release) summary.release = &*scene.release;
    if (options.reference) summary.reference = &reference;
    summary.size = scene.size;
    if (scenario.goal)
        if (const auto score = referee.decide()) summary.score = *score;
    outputs.draw_results(session);
    if (auto closed = outputs.close(session, scene.commands); !closed) return tl::unexpected(closed.error());
    if (options.export_folder) {
        const auto exported =
            options.iseesnow
                ? export_iseesnow(*options.export_folder, *options.export_name, *options.release, summary)
                : export_results(*options.export_folder, scenario, session, summary);
        if (!exported) return tl::unexpected(exported.error());
    }
    if (auto told = tell(summary, options.results); !told) return tl::unexpected(told.error());
    return *ended != Ended::kLimit && !loses_release(options, scene) ? 0 : Failure::kBadAnswer;
}

// A failure that also says where the recording is whose name this run has taken.
Failure with_replaced(Failure failure, const Session& session) {
    if (session.recorder() && session.recorder()->replaced())
        failure.sentence += fmt::format("; what {} held before is kept as {}", session.recorder()->name(),
                                        *session.recorder()->replaced());
    return failure;
}

}  // namespace

Outcome<int> run(const RunOptions& options) {
    if (auto fits = Outputs::check(options); !fits) return tl::unexpected(fits.error());
    auto scene = scene_of(options);
    if (!scene) return tl::unexpected(scene.error());
    if (options.view)
        if (auto looked = look_from(*options.view, scene->scenario); !looked)
            return tl::unexpected(looked.error());
    const Scenario& scenario = scene->scenario;
    const auto reference = reference_of(options, scenario);
    if (!reference) return tl::unexpected(reference.error());
    if (auto sound = files_of(options, *scene, *reference).check(); !sound)
        return tl::unexpected(sound.error());
    auto session = Session::begin(scenario, options.step_options, std::nullopt);
    if (!session) return tl::unexpected(session.error());
    if (auto possible = check_ahead(session->state(), scene->commands); !possible)
        return tl::unexpected(possible.error());
    auto outputs = open_outputs(options, scenario, *session);
    if (!outputs) return tl::unexpected(outputs.error());
    if (auto opened = outputs->open_film(scenario, *session, scene->commands,
                                         until_of(options, scenario.params), options.step_options);
        !opened)
        return tl::unexpected(opened.error());
    // The recording last, because the others may fail, and a recording of that name is worth more than the beginning of one.
    if (auto begun = begin_recording(options, scenario, *session); !begun)
        return tl::unexpected(begun.error());
    tell_warnings(options, *scene);
    auto status = play_and_write(options, *scene, *reference, *session, *outputs);
    if (!status) return tl::unexpected(with_replaced(status.error(), *session));
    session->delete_replaced();
    return status;
}

}  // namespace game
