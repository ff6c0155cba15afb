#include <algorithm>

#include <fmt/format.h>

#include "game/analysis/best_runs.h"
#include "game/analysis/headless.h"
#include "game/analysis/measures.h"
#include "game/analysis/summary.h"
#include "game/app/poster.h"
#include "game/base/print.h"
#include "game/commands/outputs.h"
#include "game/compare/desync_picture.h"
#include "game/files/assets.h"
#include "game/files/file_use.h"
#include "game/files/text_file.h"
#include "game/recording/file_hash.h"
#include "game/recording/recording_file.h"
#include "game/scene/scene.h"
#include "game/session/verifier.h"
#include "game/share/share_recording.h"
#include "game/sound/sound_file.h"
#include "render/mountain/overview.h"

namespace game {
namespace {

// Execution options that differ from the given ones as much as possible.
sim::StepOptions other_way(sim::StepOptions step_options) {
    step_options.threads = step_options.threads == 1 ? 3 : 1;
    step_options.tile_width = 32, step_options.tile_height = 8;
    step_options.last_tile_first = true;
    return step_options;
}

std::string name_of(const sim::StepOptions& step_options, bool swept) {
    std::string threads =
        fmt::format("{} thread{}", step_options.threads, step_options.threads > 1 ? "s" : "");
    if (!swept) return threads;
    return fmt::format("{}, tiles of {}x{}{}", threads, step_options.tile_width, step_options.tile_height,
                       step_options.last_tile_first ? " in reverse order" : "");
}

// What the score is of: the challenge that this program ships, or another.
std::string challenge_text(const Scenario& scenario) {
    Overrides overrides;
    overrides.squares = std::max(scenario.grid.nx, scenario.grid.ny) - 1;
    const auto shipped = find_asset(AssetKind::kScene, scenario.scene);
    const auto scene = shipped ? load_scene(scenario.scene, overrides) : unusable("none");
    return scene && is_same_challenge(scene->scenario, scenario)
               ? fmt::format("the challenge {} as it ships", scenario.scene)
               : fmt::format("a challenge of its own, {}", scenario.scene);
}

// Puts a scored try among the best runs of its challenge.
Outcome<void> keep(const Recording& recording, const std::filesystem::path& file, const Score& score,
                   const StateLine& at_end) {
    if (!score.meets_needs()) {
        print_line(stderr, "couloir: not kept: {}", reason_of(*recording.header.scenario.goal, score));
        return {};
    }
    const auto folder = best_runs_folder(recording.header.scenario);
    if (!folder) return tl::unexpected(folder.error());
    const auto text = recording_of_try(recording, file.stem().string(), score, at_end);
    if (!text) return tl::unexpected(text.error());
    if (auto kept = keep_run(*folder, score, at_end.hash, *text); !kept) return kept;
    const auto best = best_runs(*folder);
    const auto place = std::ranges::find(best, at_end.hash, &BestRun::hash);
    if (place == best.end())
        print_line(stderr, "couloir: not among the best {} runs here", kMostBestRuns);
    else
        print_line(stderr, "couloir: number {} of the best runs here", place - best.begin() + 1);
    return {};
}

// Why a claimed score cannot be believed; nothing if it can, or if there is none.
std::optional<std::string> fault_of_claim(const std::optional<ClaimLine>& claim, const Score& score) {
    if (!claim || *claim == score.claim()) return std::nullopt;
    return fmt::format("it claims a score of {} ({}) at tick {}; its commands give {} ({}) at tick {}",
                       claim->score, medal_name(claim->medal), claim->tick, score.points,
                       medal_name(score.medal), score.tick);
}

}  // namespace

Outcome<int> replay(const ReplayOptions& options) {
    const auto path = find_asset(AssetKind::kRecording, options.recording);
    if (!path) return tl::unexpected(path.error());
    if (auto fits = Outputs::check(options); !fits) return tl::unexpected(fits.error());
    Memory memory = options.memory;
    memory.use.runs = options.paranoid ? 2 : 0;
    Outputs::add_to(memory.use, options);
    if (options.poster) {
        memory.use.draws = true;
        memory.use.frames.width = std::max(memory.use.frames.width, Poster::kPicture.width);
        memory.use.frames.height = std::max(memory.use.frames.height, Poster::kPicture.height);
    }
    auto recording = read_recording(*path, memory);
    if (!recording) return tl::unexpected(recording.error());
    if (recording->warning) print_line(stderr, "couloir: warning: {}", *recording->warning);
    if (options.until)
        if (auto has = check_tick(*recording, *options.until, options.recording); !has)
            return tl::unexpected(has.error());
    if (auto taken = take_look(options.look, recording->header.scenario); !taken)
        return tl::unexpected(taken.error());
    if (options.view)
        if (auto looked = look_from(*options.view, recording->header.scenario); !looked)
            return tl::unexpected(looked.error());
    const Scenario& scenario = recording->header.scenario;
    if (options.score && !scenario.goal)
        return unusable(fmt::format("{}: its scene has no goal, so there is no score", options.recording));
    if (options.score && !is_comparable(recording->header))
        return unusable(
            fmt::format("{}: recorded with another version of the physics, so its score means nothing here",
                        options.recording));

    FileUse use;
    use.reads(*path);
    Outputs::add_to(use, options);
    use.writes_into("--frames", options.pictures.folder, kFrameNames);
    use.writes("--audio", options.audio);
    use.writes("--poster", options.poster);
    if (options.poster) use.reads(drawing_assets());
    if (auto sound = use.check(); !sound) return tl::unexpected(sound.error());
    const std::int64_t last = options.until.value_or(recording->last_tick());
    auto session = Session::begin(scenario, options.step_options, std::nullopt);
    if (!session) return tl::unexpected(session.error());
    auto outputs = Outputs::begin(options, scenario, *session, proof_of(options.recording));
    if (!outputs) return tl::unexpected(outputs.error());
    if (auto opened = outputs->open(scenario); !opened) return tl::unexpected(opened.error());
    const render::Camera camera = scenario.camera.value_or(render::overview(session->view()));
    if (options.poster) {
        if (auto placed = make_place_for(*options.poster); !placed) return tl::unexpected(placed.error());
        session->follow_powder(scenario);
        session->follow_carried(scenario);
        session->follow_fronts(scenario);
    }
    std::optional<sound::SoundFile> audio;
    if (options.audio) {
        session->follow_powder(scenario);  // which is heard too
        auto opened = sound::SoundFile::open(*options.audio, *session, last, camera);
        if (!opened) return tl::unexpected(opened.error());
        audio.emplace(std::move(*opened));
    }
    const auto until = Until::after(last);
    if (auto opened =
            outputs->open_film(scenario, *session, recording->commands, until, options.step_options);
        !opened)
        return tl::unexpected(opened.error());
    Verifier verifier(*recording);
    Referee referee(scenario, recording->commands);

    Watchers watchers = outputs->watch(scenario, *session,
                                       {scenario.scene, file_hash(*path), options.step_options.threads, {}});
    if (options.verify) verifier.look_at(*session);
    const Side way{scenario, recording->commands, options.step_options},
        other{scenario, recording->commands, other_way(options.step_options)};
    std::optional<LockstepRun> lockstep;
    SelfCheck self_check;
    StateLine at_end;  // of the try
    if (options.paranoid) {
        const bool swept = !options.step_options.plain && !scenario.lower;
        self_check.names = {name_of(way.options, swept), name_of(other.options, swept)};
        self_check.parted = lockstep.emplace(way, other).follow(session->state());
    }
    watchers.after_tick = [&](const Session& now) {
        if (options.verify) verifier.look_at(now);
        if (options.score) referee.see(now);
        if (options.keep && now.try_ended_at() == now.state().tick) at_end = now.state_line();
        if (!lockstep || self_check.parted) return;
        self_check.parted = lockstep->follow(now.state());
        self_check.ticks = now.state().tick;
    };
    if (audio)
        watchers.keep = [&, others = watchers.keep](const Session& now) -> Outcome<void> {
            if (others)
                if (auto kept = others(now); !kept) return kept;
            return audio->see(now, commands_of_tick(recording->commands, now.state().tick - 1));
        };
    if (auto played =
            play_headless(*session, recording->commands, until, watchers, outputs->doing("replaying"));
        !played)
        return tl::unexpected(played.error());
    if (audio)
        if (auto closed = audio->close(); !closed) return tl::unexpected(closed.error());
    if (auto closed = outputs->close(*session, recording->commands); !closed)
        return tl::unexpected(closed.error());

    if (options.poster) {
        const auto page = Poster::draw({scenario, *session, recording->commands, path->stem().string()},
                                       options.pictures.gl);
        if (!page) return tl::unexpected(page.error());
        if (auto written = render::write_png(*page, *options.poster); !written)
            return machine_fails(written.error());
    }

    const Measures measures = measure(scenario, *session, release_area(scenario, recording->commands), {});
    Summary summary{scenario, *session, measures, &outputs->perf(), std::nullopt, std::nullopt};
    if (options.verify) summary.verdict = verifier.verdict();
    if (options.score) {
        const auto score = referee.decide();
        if (!score)
            return tl::unexpected(Failure{score.error().status,
                                          fmt::format("{}: {}", options.recording, score.error().sentence)});
        summary.score = *score;
    }
    if (options.paranoid) summary.paranoid = self_check;
    if (self_check.parted && options.pictures.folder)
        if (auto drawn = render::write_png(desync_picture(*self_check.parted, scenario, self_check.names),
                                           *options.pictures.folder / "desync.png");
            !drawn)
            return machine_fails(drawn.error());
    if (auto told = tell(summary, options.results); !told) return tl::unexpected(told.error());
    const bool proven = verifier.verdict().kind() == Verdict::Kind::kExact;
    if (summary.score) {
        print_line(stderr, "couloir: scored {}", challenge_text(scenario));
        if (const auto wrong = fault_of_claim(recording->claim, *summary.score))
            return tl::unexpected(
                Failure{Failure::kBadAnswer, fmt::format("{}: {}", options.recording, *wrong)});
    }
    if (options.keep && summary.score)
        if (auto kept = keep(*recording, *path, *summary.score, at_end); !kept)
            return tl::unexpected(kept.error());
    const bool bad = (options.verify && !proven) || self_check.parted;
    return bad ? Failure::kBadAnswer : 0;
}

}  // namespace game
