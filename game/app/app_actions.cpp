// What the app does for each action. The frame is in app.cpp.

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>
#include <glm/trigonometric.hpp>

#include "game/app/app.h"
#include "game/base/process.h"
#include "game/controls/front_view.h"
#include "game/controls/key_map.h"
#include "game/files/recordings_folder.h"
#include "game/files/user_folders.h"
#include "game/recording/format.h"
#include "game/recording/recording_file.h"
#include "game/scene/goal_reach.h"
#include "game/scene/scene_ground.h"
#include "game/scene/surface.h"
#include "game/scene/week.h"
#include "game/session/world_now.h"
#include "game/words/words.h"
#include "render/mountain/overview.h"

namespace game {
namespace {

// What a software renderer may take for the buffers of an image, beside the world, bytes.
std::uint64_t memory_for_frames(const LoadedWorld& loaded) {
    const Scenario& scenario = loaded.scene.scenario;
    Memory without = loaded.memory;
    without.use.frames = {};
    const std::uint64_t world = expected_bytes(scenario.grid, scenario.lower.has_value(), without);
    return loaded.memory.most - std::min(loaded.memory.most, world);
}

}  // namespace

void App::perform(Verb verb) {
    if (photo_.is_on() && perform_in_photo(verb)) return;
    if (verb == Verb::kClosePanel && has_card()) {
        open_.results.close_card();
        return;
    }
    if (ui_.perform(verb)) return;
    switch (verb) {
        case Verb::kPauseOrGoOn:
            if (open_.lesson && open_.lesson->open()) return go_on_with_lesson();
            return pause(!time_.clock().paused());
        case Verb::kStepOnce:
            pause(true);
            return time_.clock().step_once();
        case Verb::kSlower:
            return time_.clock().set_speed(time_.clock().speed() / 2);
        case Verb::kFaster:
            return time_.clock().set_speed(time_.clock().speed() * 2);
        case Verb::kUsualSpeed:
            return time_.clock().set_speed(1);
        case Verb::kStepBack:
            return step_back();
        case Verb::kRunBack:
            return run_back();
        case Verb::kMarkBefore:
            return go_to_mark(open_.marks.before(shortly_before()));
        case Verb::kMarkAfter:
            return go_to_mark(open_.marks.after(sandbox_->session().state().tick));
        case Verb::kSkip:
            return skip();
        case Verb::kTakeOver:
            return take_over();
        case Verb::kUndo:
            return undo();
        case Verb::kRedo:
            return redo();
        case Verb::kReset:
            return reset();
        case Verb::kSmallerBrush:
            return hand_.resize(-1, sandbox_->scenario().grid);
        case Verb::kLargerBrush:
            return hand_.resize(1, sandbox_->scenario().grid);
        case Verb::kWeakerBrush:
            return hand_.strengthen(-1);
        case Verb::kStrongerBrush:
            return hand_.strengthen(1);
        case Verb::kPourStandingOrRolling:
            return hand_.pour_otherwise();
        case Verb::kOverview:
            lookout_.control().set_home(home());
            return lookout_.control().overview();
        case Verb::kTopDown:
            lookout_.control().top_down(lookout_.control().mode() != CameraMode::kTopDown);
            return tell_camera_mode();
        case Verb::kFly:
            lookout_.control().fly(lookout_.control().mode() != CameraMode::kFly);
            return tell_camera_mode();
        case Verb::kChase:
            lookout_.control().chase(lookout_.control().mode() != CameraMode::kChase);
            return tell_camera_mode();
        case Verb::kShare:
            return share();
        case Verb::kPhoto:
            return begin_photo();
        case Verb::kLabels:
            display_.labels = !display_.labels;
            return;
        case Verb::kScreenshot:
            return screenshots_.ask();
        case Verb::kSlowMotion:
            return time_.slow_motion();
        case Verb::kSpeedColours:
            display_.overlay = display_.overlay == render::Overlay::kSpeed ? render::Overlay::kNone
                                                                           : render::Overlay::kSpeed;
            return;
        case Verb::kFieldWords:
            display_.field_words = !display_.field_words;
            return tell(tr(display_.field_words ? "The field's words: standing and rolling layer, aspect"
                                                : "Plain words: cover, flow, where a slope faces"));
        case Verb::kMute:
            display_.volumes.muted = !display_.volumes.muted;
            return tell(tr(display_.volumes.muted ? "Sound off" : "Sound on"));
        case Verb::kFullscreen:
            return screen_.set_fullscreen(!screen_.fullscreen());
        case Verb::kQuit:
            leaving_ = true;
            return;
        default:
            return;  // panel verbs, handled by ui_
    }
}

// The world stands still, and only the camera moves.
bool App::perform_in_photo(Verb verb) {
    const bool is_taken = image_.photo_progress().has_value();
    switch (verb) {
        case Verb::kPhoto:
        case Verb::kClosePanel:
            if (!is_taken) {
                end_photo();
                return true;
            }
            image_.drop_photo();
            tell(tr("The photo was stopped; nothing of it is kept"));
            return true;
        case Verb::kTakeOver:
        case Verb::kScreenshot:
            screenshots_.ask();
            return true;
        case Verb::kMenu:
            end_photo();
            return false;
        case Verb::kOverview:
        case Verb::kTopDown:
        case Verb::kFly:
        case Verb::kChase:
            return is_taken;
        case Verb::kFullscreen:
        case Verb::kMute:
        case Verb::kQuit:
            return false;
        default:
            return true;
    }
}

void App::begin_photo() {
    if (screen_.size().width == 0) return;
    hand_.drop();
    const auto middle = lookout_.land_under({0, 0}, sandbox_->session().view());
    photo_.begin(sandbox_->scenario(), lookout_.control(), display_.light, display_.date, lookout_.aspect(),
                 lookout_.ground().value_or(middle.value_or(camera().target)));
}

void App::end_photo() {
    photo_.end(lookout_.control());
    image_.drop_photo();
}

void App::perform(const SetPhoto& set) {
    if (photo_.is_on() && !image_.photo_progress()) photo_.set(set.settings);
}

// A stroke that is held while time is paused ends there, because it would let time run on.
void App::pause(bool on) {
    time_.clock().pause(on);
    if (on) hand_.release();
}

void App::perform(const SetSpeed& set) {
    time_.clock().set_speed(set.speed);
}
void App::perform(Tool tool) {
    const Scenario& scenario = sandbox_->scenario();
    if (!is_offered(info_of(tool), scenario, sandbox_->session().state()))
        return tell(scenario.goal && !tool_of(*scenario.goal, deed_of(tool).kind)
                        ? said("{} is no tool of this challenge", tr(deed_of(tool).label))
                        : said("{} needs soil: a material heavier than water that has friction",
                               tr(deed_of(tool).label)));
    hand_.choose(tool);
}
void App::perform(const SetBrush& set) {
    hand_.set(set.brush);
}
void App::perform(const SetDisplay& set) {
    if (!(set.display.flow == display_.flow)) sandbox_->set_flow(set.display.flow);
    if (set.display.tier != display_.tier) {
        image_.end_trial();
        now_set_.tier = set.display.tier;
    }
    display_ = set.display;
    if (runs_) runs_->choose(display_.probability);
}
void App::perform(const Open& open) {
    const bool opened = open_or_tell(open.name_or_path, open.overrides);
    if (opened && open.goes_on && sandbox_->watches()) take_over_at(sandbox_->known_until());
}

void App::perform(const BindKey& wish) {
    now_set_.keys.bind(wish.row, {wish.key, wish.with});
}

void App::perform(const ResetKeys&) {
    now_set_.keys = {};
}

void App::perform(const LookAt& wish) {
    const sim::View world = sandbox_->session().view();
    render::Camera there = camera();
    there.target = {wish.place, surface_height(world, wish.place)};
    lookout_.control().go_to(there);
}

// It ends when the slide has come to rest again (run_ticks), or when the user goes elsewhere in time.
void App::perform(const SeeFromFront&) {
    const ui::ResultCard* const card = open_.results.card(*sandbox_);
    if (!card || !may_go_back()) return;
    lookout_.control().go_to(view_from_front(sandbox_->session().view(), card->top, card->toe));
    time_.see_again(open_.results.began());
}

void App::perform(const GuideWish& wish) {
    tutorial_.perform(wish);
}

// What the user has recorded and saved by now.
void App::list_own() {
    for (const ShelfKind kind : kShelfKinds) catalogue_.own_of(kind) = own_entries(kind);
}

void App::perform(const SaveWorld& wish) {
    if (sandbox_->looks_back()) return tell_hands_off();
    const sim::State& state = sandbox_->session().state();
    const auto saved = scenario_of_now(sandbox_->scenario(), state).and_then([&](Scenario&& now) {
        now.camera = camera();
        now.camera->azimuth_deg =
            std::remainder(now.camera->azimuth_deg, 360.0);  // it may have turned on and on
        now.light = display_.light;
        now.look.date = display_.date;
        const std::string name = wish.name.empty() ? shelf_name(now.title) : wish.name;
        return keep_on_shelf(ShelfKind::kWorld, name, recording_of(now));
    });
    skip_wait();
    if (!saved) return warn(said("This world is not saved: {}", saved.error().sentence));
    if (!image_.failure()) put_picture(*saved, small_picture(image_.shown()));
    list_own();
    tell(said("Saved as {}{}", saved->string(), not_kept(state)));
}

void App::put_picture(const std::filesystem::path& recording, const render::Picture& small) {
    if (const auto written = write_beside(recording, small); !written) warn(written.error().sentence);
}

void App::perform(const MakeChallenge&) {
    if (maker_.is_busy()) return tell(tr("A challenge is being made already"));
    if (sandbox_->scenario().goal) return tell(tr("This world is a challenge already"));
    const Scenario& scenario = sandbox_->scenario();
    Memory memory = first_.memory;
    memory.use.sessions = 2;  // it is played again
    const bool has_things = sandbox_->session().state().things.has_value();
    if (const auto fits = memory.allows(scenario.grid, scenario.lower.has_value(), has_things); !fits)
        return warn(said("No challenge: {}", fits.error()));
    sim::StepOptions options;
    options.threads = 1;  // the window goes on
    std::optional<render::Picture> picture = open_.picture.picture();
    if (!picture && !image_.failure()) picture = small_picture(image_.shown());
    if (const auto begun = maker_.begin(scenario, sandbox_->history(), options, std::move(picture)); !begun)
        return warn(said("No challenge: {}", begun.error().sentence));
    tell(tr("Your slide is played again, to prove that the challenge can be won"));
}

void App::tell_made() {
    const auto made = maker_.result();
    if (!made) return;
    if (!*made) return warn(said("No challenge: {}", made->error().sentence));
    if (const auto picture = maker_.picture()) put_picture((*made)->file, *picture);
    list_own();
    tell(said("Your challenge, gold from {} m, is in the menu under My hill: {}", (*made)->gold,
              (*made)->file.string()));
}

void App::perform(const CoverGround& wish) {
    if (!is_bare(sandbox_->scenario(), sandbox_->session().state()) || sandbox_->watches()) return;
    LoadedWorld covered = first_;
    cover_ground(covered.scene.scenario, wish.depth);
    covered.told = said("The ground is covered with {:.1f} m, but for what is steeper than {:.0f}°",
                        wish.depth, kBareSlope);
    const Brush brush = hand_.brush();
    const CameraControl camera = lookout_.control();
    if (const auto begun = begin_world(std::move(covered), std::nullopt); !begun)
        return warn(begun.error().sentence);
    // It is the same hill to who plays.
    hand_.set(brush);
    lookout_.control() = camera;
}

void App::perform(const TryChallenge&) {
    if (!first_.watched || !first_.scene.scenario.goal) return;
    if (const auto wrong = fault_of_reach(first_.scene.scenario))
        return warn(said("Nobody can win this challenge: {}", to_text(*wrong)));
    LoadedWorld own = first_;
    own.watched.reset();
    own.name.clear();
    own.scene.commands = own.scene.scenario.goal->events;
    own.told = tr("Your turn");
    if (const auto begun = begin_afresh(std::move(own)); !begun) warn(begun.error().sentence);
}

void App::perform(const SetNumber& set) {
    if (is_read_only()) return tell_hands_off();
    // So that a recording contains 0.6, not 0.6000000238418579.
    const double value = shortest(set.value);
    if (const auto fault = hand_.set_number(sandbox_->session().state().params, set.param, value))
        return warn(said("Parameter not set: {}", *fault));
    sandbox_->begin_action(said("set {}", sim::kParams[set.param].name));
    if (time_.clock().paused()) tell(tr("Paused: the parameter changes on the next tick"));
}

// The pose of the scene, or one that shows the whole terrain, such that its image would fit into the rows of the window
// that the bars leave free. From a pose of the scene's own, which may stand close to the ground, the view widens,
// unless it is wide already.
render::Camera App::home() const {
    constexpr double kImageAspect = 16.0 / 9.0, kWidest = 62;  // degrees; more would look distorted
    const auto& own = sandbox_->scenario().camera;
    render::Camera camera = own ? *own : render::overview(sandbox_->session().view());
    const ScreenSize size = screen_.size();
    if (size.width == 0) return camera;
    const double height = size.height, aspect = size.width / height;
    const double times =
        std::max({1.0, height / ui_.free_height(size, display_.letters), kImageAspect / aspect});
    if (!own) {
        camera.distance_m *= times;
    } else if (camera.field_of_view_deg < kWidest) {
        const double wide = 2 * std::atan(times * std::tan(glm::radians(camera.field_of_view_deg) / 2));
        camera.field_of_view_deg = std::min(glm::degrees(wide), kWidest);
    }
    return camera;
}

// Shows a notice, because neither mode is visible in the image.
void App::tell_camera_mode() {
    const Keys keys = this->keys();
    if (lookout_.control().mode() == CameraMode::kTopDown)
        tell(said("Top view, north up. Drag with the middle button to pan; press {} to return",
                  name_of(keys, Verb::kTopDown)));
    if (lookout_.control().mode() == CameraMode::kChase)
        tell(said("The camera follows the front of {}. Press {} to stop",
                  sim::flows(sandbox_->session().state()) ? tr("the slide") : tr("the next slide"),
                  name_of(keys, Verb::kChase)));
    if (lookout_.control().mode() == CameraMode::kFly)
        tell(said("Fly mode. Move with {} or arrows, look with the right button; press {} to return",
                  names_of_walking(keys), name_of(keys, Verb::kFly)));
}

void App::undo() {
    stop_hand();
    // Parameters waiting for the next tick have no effect yet: discard them and nothing else.
    if (hand_.drop_numbers()) return tell(tr("Undone: parameters set for the next tick"));
    const auto undone = sandbox_->undo();
    time_.jump();
    if (!undone && undone.error().status == Failure::kMachine) {
        file_.stop(undone.error());
        return warn(said("Undone, but recording has stopped: {}", undone.error().sentence));
    }
    if (!undone) return tell(undone.error().sentence);
    tell(said("Undone: {}. Back at {:.1f} s", *undone, sandbox_->session().seconds()));
}

void App::redo() {
    stop_hand();
    const auto redone = sandbox_->redo();
    time_.jump();
    if (!redone && redone.error().status == Failure::kMachine) {
        file_.stop(redone.error());
        return warn(said("Redone, but recording has stopped: {}", redone.error().sentence));
    }
    if (!redone) return tell(redone.error().sentence);
    // What follows the action is known, so the world only has to get there.
    const std::int64_t end = sandbox_->known_until();
    time_.go_to(end);
    const double tick_s = static_cast<double>(sandbox_->scenario().params.tick_s);
    tell(said("Redone: {}. On to {:.1f} s", *redone, static_cast<double>(end) * tick_s));
}

// Ends what the user is doing to the world or to time.
void App::stop_hand() {
    hand_.drop();
    time_.run_on();
}

bool App::may_go_back() {
    if (!sandbox_->can_go_back()) tell(tr("Flow demos cannot be rewound"));
    return sandbox_->can_go_back();
}

void App::perform(const SeekTick& seek) {
    if (may_go_back()) time_.go_to(seek.tick);
}

void App::step_back() {
    time_.clock().pause(true);
    perform(SeekTick{sandbox_->session().state().tick - 1});
}

// Who asks for the mark before shortly after one means the one before that.
std::int64_t App::shortly_before() const {
    constexpr double kShortly = 1;  // s
    const sim::State& state = sandbox_->session().state();
    return state.tick - std::lround(kShortly / static_cast<double>(state.params.tick_s));
}

void App::go_to_mark(const std::optional<std::int64_t>& tick) {
    if (!tick) return tell(tr("No mark on the timeline lies there"));
    perform(SeekTick{*tick});
}

// What is known is gone to; what is not is run as fast as the machine can.
void App::skip() {
    if (sandbox_->looks_back()) return perform(SeekTick{sandbox_->known_until()});
    if (sim::at_rest(sandbox_->session().state()))
        return tell(tr("Nothing moves, so there is no end to skip to"));
    open_.skips = !open_.skips;
    if (open_.skips) time_.clock().pause(false);
}

void App::run_back() {
    if (!may_go_back()) return;
    time_.turn_round();
    // Time in which everything lay still is passed at once.
    const Session& session = sandbox_->session();
    if (time_.clock().runs_back() && session.changed_at() < session.state().tick)
        time_.rewind_to(session.changed_at());
}

void App::take_over_at(std::int64_t tick) {
    time_.take_over_at(tick);
}

void App::take_over() {
    if (!sandbox_->watches() && !sandbox_->looks_back())
        return tell(tr("Already at the present: brushes and parameters work here"));
    const auto& wanted = file_.wanted();
    const auto path = wanted && sandbox_->watches() ? Outcome<std::filesystem::path>(*wanted)
                                                    : next_recording(sandbox_->scenario().scene);
    time_.run_on();
    time_.begin_epoch();
    open_.lesson.reset();
    open_.lesson_marks.clear();
    const double seconds = sandbox_->session().seconds();
    auto taken = sandbox_->take_over(into_file(path ? std::optional(*path) : std::nullopt));
    if (!path) taken = tl::unexpected(path.error());
    list_own();
    if (!taken) {
        file_.stop(taken.error());
        return warn(said("You can continue from here, but it is not recorded: {}", taken.error().sentence));
    }
    file_.begin(sandbox_->session().recorder() ? std::optional(*path) : std::nullopt);
    tell(said("Branched at {:.1f} s into a new recording. The original keeps what came after", seconds));
}

void App::tell_hands_off() {
    tell(said("Read-only: {}. Press {} to continue from here",
              tr(sandbox_->watches() ? "watching a recording" : "looking at the past"),
              name_of(keys(), Verb::kTakeOver)));
}

void App::reset() {
    LoadedWorld again = first_;
    again.told = said(
        "Restarted: {}{}", tr(first_.scene.scenario.title.c_str()),
        file_.remains(sandbox_->was_touched()) ? tr(". The previous session stays in its recording") : "");
    if (const auto begun = begin_world(std::move(again), file_.wanted()); !begun)
        warn(begun.error().sentence);
}

void App::share() {
    const Session& session = sandbox_->session();
    if (sandbox_->scenario().flow) return tell(tr("A flow demo cannot be shared: it has no slide to play"));
    // In the first tick all is looked at, so that it counts as changed.
    if (sandbox_->known_until() == session.state().tick && session.changed_at() <= 1) {
        if (sandbox_->scenario().goal) return perform(ChallengeFriend{});
        return tell(tr("Nothing to share yet, because nothing has moved. Release a slide first"));
    }
    share(sandbox_->watches() ? watched_text(sandbox_->opening()) : sandbox_->recorded_so_far());
}

void App::perform(const ChallengeFriend&) {
    share(recording_of(sandbox_->scenario()));
}

void App::share(Outcome<std::string> recording) {
    if (sharing_.progress()) return tell(tr("A slide is being shared already. Share the next one after it"));
    Memory memory = first_.memory;
    memory.use.sessions = 2;  // the page plays the slide anew
    memory.use.page = true;
    const Scenario& scenario = sandbox_->scenario();
    if (const auto fits = memory.allows(scenario.grid, scenario.lower.has_value()); !fits)
        return warn(said("This slide cannot be shared: {}", fits.error()));
    PageOptions options{.camera = camera()};
    if (open_.lesson) options.lesson = std::make_shared<const Lesson>(*first_.lesson);
    const auto begun = std::move(recording).and_then([&](std::string&& recorded) {
        return sharing_.begin(std::move(recorded), dated_name(scenario.scene), options);
    });
    open_.results.set_may_share(false);
    if (!begun) warn(said("This slide cannot be shared: {}", begun.error().sentence));
}

void App::perform(const FilmSlide& film) {
    const Session& session = sandbox_->session();
    const Scenario& scenario = sandbox_->scenario();
    const std::int64_t known = sandbox_->known_until();
    if (filming_.progress()) return tell(tr("A film is being made already. Start the next one after it"));
    if (known == session.state().tick && session.changed_at() <= 1)
        return tell(tr("Nothing to film yet, because nothing has moved. Release a slide first"));
    if (film.wish.view == FilmView::kPath && !path_.is_path())
        return tell(tr("A camera path needs two keys or more: add them in the Film panel"));
    Memory memory = first_.memory;
    memory.use.sessions = 2;  // the film plays the slide anew
    memory.use.draws = true;
    memory.use.frames = {film.wish.width, film.wish.height};
    if (const auto fits = memory.allows(scenario.grid, scenario.lower.has_value()); !fits)
        return warn(said("This slide cannot be filmed: {}", fits.error()));
    // Until shortly after all has come to rest, if that is known.
    constexpr double kAfter = 2;  // s
    const auto after = static_cast<std::int64_t>(kAfter / static_cast<double>(scenario.params.tick_s));
    const bool is_at_end = known == session.state().tick;
    const std::int64_t last = is_at_end ? std::min(known, session.changed_at() + after) : known;
    auto recorded = sandbox_->watches() ? watched_text(sandbox_->opening()) : sandbox_->recorded_so_far();
    const auto begun = std::move(recorded).and_then([&](std::string&& text) {
        return filming_.begin({.recording = std::move(text),
                               .name = dated_name(scenario.scene),
                               .last = last,
                               .camera = camera(),
                               .light = display_.light,
                               .date = display_.date,
                               .path = path_.keys()},
                              film.wish);
    });
    if (!begun) warn(said("This slide cannot be filmed: {}", begun.error().sentence));
}

// The recording that is being written, or that is watched and may be read again.
bool App::is_in_use(const std::filesystem::path& file) {
    const bool used = file == file_.path() || (sandbox_->watches() && file == first_.scene.files.front());
    if (used) tell(tr("This recording is open. Open something else first"));
    return used;
}

void App::perform(const RenameFile& wish) {
    if (is_in_use(wish.file)) return;
    const auto renamed = rename_on_shelf(wish.file, wish.name);
    list_own();
    if (!renamed) return warn(renamed.error().sentence);
    tell(said("Renamed: {}", renamed->filename().string()));
}

void App::perform(const ThrowAway& wish) {
    if (is_in_use(wish.file)) return;
    const auto thrown = throw_away(wish.file);
    list_own();
    if (!thrown) return warn(thrown.error().sentence);
    tell(said("In the trash: {}", wish.file.filename().string()));
}

void App::perform(const ShowFile& wish) {
    if (!show_folder(wish.file.parent_path())) tell(said("It is in {}", wish.file.parent_path().string()));
}

void App::perform(const StopFilm&) {
    filming_.stop();
    tell(tr("The film was stopped; nothing of it is kept"));
}

void App::perform(const DrawSection& wish) {
    open_.measuring.wait_for_line(wish.waits);
}

void App::perform(const LessonWish& wish) {
    if (!open_.lesson) return;
    if (wish.answer) return open_.lesson->answer(*wish.answer);
    go_on_with_lesson();
}

// From its stop, wherever time was scrubbed to meanwhile.
void App::go_on_with_lesson() {
    const auto tick = open_.lesson->go_on();
    if (!tick) return;
    if (sandbox_->session().state().tick != *tick) time_.go_to(*tick);
    pause(sandbox_->known_until() == *tick);
}

void App::tell_film() {
    const auto made = filming_.result();
    if (!made) return;
    if (!*made) return warn(said("No film was made: {}", made->error().sentence));
    tell(said("Film: {:.0f} s, {}", (*made)->seconds, (*made)->file.string()));
    if (!(*made)->notice.empty()) warn((*made)->notice);
    if (display_.shows_shared) show_folder((*made)->file.parent_path());
}

// Of what other threads have written.
void App::tell_results() {
    best_list_.mark(catalogue_.scenes);
    tell_made();
    tell_film();
    while (const auto screenshot = screenshots_.result()) {
        if (*screenshot)
            tell(said("Screenshot: {}", (*screenshot)->string()));
        else
            warn(said("No screenshot: {}", screenshot->error().sentence));
    }
    const auto shared = sharing_.result();
    if (!shared) return;
    if (!*shared) return warn(said("This slide was not shared: {}", shared->error().sentence));
    constexpr double kMegabyte = 1e6;
    tell(said("Shared: a page of {:.1f} MB for any browser, and its recording, in {}",
              static_cast<double>((*shared)->page.bytes) / kMegabyte, (*shared)->folder.string()));
    for (const std::string& notice : (*shared)->page.notices) warn(notice);
    if (display_.shows_shared) show_folder((*shared)->folder);
}

bool App::open_or_tell(const std::string& name_or_path, const Overrides& overrides) {
    Overrides within = overrides;
    within.memory = first_.memory;
    within.memory.use.sessions = 2;  // the old world exists until the new one is loaded
    within.week = this_week();
    auto loaded = open_anything(name_or_path, within);
    const auto begun = loaded ? begin_afresh(std::move(*loaded)) : tl::unexpected(loaded.error());
    if (!begun) warn(begun.error().sentence);
    return begun.has_value();
}

void App::show_runs(Runs runs) {
    runs_.emplace(std::move(runs));
    display_.overlay = render::Overlay::kProbability;
    display_.probability = 0;
    lookout_.enter(runs_->view(home(), sandbox_->session().view()), sandbox_->session().view());
    ui_.perform(Verb::kToggleDisplay);  // its legend
    pause(true);                        // it would flow over its own picture
    tell(tr("Colours: in how many runs a place was hit. Dots: where runs ended; click one to open its run"));
}

// In the colours of its material, because those of the probability would hide it.
void App::open_run(std::int64_t run) {
    auto loaded = runs_->world_of(run);
    if (!loaded) return warn(loaded.error().sentence);
    if (const auto begun = begin_afresh(std::move(*loaded)); !begun) return warn(begun.error().sentence);
    runs_->open(run);
    display_.overlay = render::Overlay::kNone;
}

Outcome<void> App::begin_afresh(LoadedWorld loaded) {
    const TickClock before = std::exchange(time_.clock(), {});
    auto begun = begin_world(std::move(loaded), std::nullopt);
    if (begun)
        ui_.close_menu();
    else
        time_.clock() = before;
    return begun;
}

Outcome<void> App::close_recording() {
    const auto recording = file_.path();
    const bool is_listed = !file_.wanted() && file_.remains(sandbox_->was_touched());
    if (is_listed && open_.picture.is_late() && !image_.failure()) open_.picture.take(image_.shown());
    auto closed = sandbox_->finish();
    if (closed) file_.end(sandbox_->was_touched());
    if (closed && recording && is_listed && open_.picture.picture())
        put_picture(*recording, *open_.picture.picture());
    return closed;
}

Outcome<void> App::begin_world(LoadedWorld loaded, std::optional<std::filesystem::path> record,
                               std::optional<Backdrop> backdrop) {
    // Reset keeps brush and camera; a different terrain does not. Another scene on the same ground has its own camera.
    // Runs may release something else on the same ground.
    const bool of_runs = runs_ && runs_->is_of(loaded.scene.scenario);
    const bool same =
        sandbox_ && (of_runs || ground_hash(sandbox_->scenario()) == ground_hash(loaded.scene.scenario));
    const bool same_scene = same && sandbox_->scenario().scene == loaded.scene.scenario.scene;
    const bool same_path =
        same_scene && sandbox_->scenario().camera_path == loaded.scene.scenario.camera_path;
    if (auto ready = image_.load(loaded.scene.scenario); !ready) return ready;
    // While a recording is watched, nothing is recorded until it is taken over.
    Outcome<std::optional<Recorder>> recorder;
    if (!loaded.watched) recorder = begin_recording(loaded.scene.scenario, record);
    if (!recorder) return tl::unexpected(recorder.error());
    std::optional<std::filesystem::path> recording;
    if (*recorder) recording = (*recorder)->name();
    auto begun = Sandbox::begin(loaded, options_, std::move(*recorder));
    if (!begun && recording && !record) {
        warn(said("This session is not recorded: {}", begun.error().sentence));
        recording.reset();
        begun = Sandbox::begin(loaded, options_, std::nullopt);
    }
    if (!begun) return tl::unexpected(begun.error());
    if (sandbox_)
        if (const auto closed = close_recording(); !closed) {
            file_.stop(closed.error());
            warn(closed.error().sentence);
        }
    if (!of_runs) runs_.reset();
    if (photo_.is_on()) end_photo();
    sandbox_ = std::move(*begun);
    sounds_.listen_to(sandbox_->session());
    first_ = std::move(loaded);
    open_ = {};
    if (first_.lesson) {
        open_.lesson.emplace(*first_.lesson, static_cast<double>(first_.scene.scenario.params.tick_s));
        time_.clock().pause(false);  // from its last stop
    }
    if (first_.watched)
        open_.marks.begin(first_.watched->commands,
                          open_.lesson ? open_.lesson->ticks() : std::span<const std::int64_t>());
    image_.begin_world(memory_for_frames(first_));
    file_.want(std::move(record));
    file_.begin(std::move(recording));
    list_own();
    time_.begin_world();

    const Scenario& scenario = sandbox_->scenario();
    path_.stop();
    if (!same_path) path_.begin(scenario.camera_path);
    best_list_.open(scenario);
    Memory with_ghost = first_.memory;
    with_ghost.use.sessions = 2;
    ghost_.follow(scenario, best_list_.runs(), with_ghost);
    hand_.drop();
    hand_.drop_numbers();
    if (!same) {
        lookout_.surround(backdrop ? std::move(*backdrop) : backdrop_of(scenario));
        display_.surroundings = !scenario.model;
        hand_.suit(scenario.grid);
    }
    if (!same_scene) {
        display_.light = scenario.light;
        display_.date = scenario.look.date;
        lookout_.enter(home(), sandbox_->session().view());
    }
    if (scenario.flow) display_.flow = scenario.flow->numbers;
    open_.probe.emplace(scenario.georeference, densities_of(scenario),
                        zero_of_heights(sandbox_->session().view(), scenario.georeference));
    screen_.show_title(fmt::format("Couloir: {}", scenario.title));
    tell(first_.told);
    if (scenario.look.flow && !sandbox_->session().fronts()) tell(Session::kTooFine);
    if (const std::string notice = woods_notice(scenario, lookout_.woods()); !notice.empty()) tell(notice);
    // A challenge that acts by itself starts paused, unless it acts at tick 0.
    const bool waits =
        scenario.goal && !scenario.goal->events.empty() && scenario.goal->events.front().tick > 0;
    if (waits && !sandbox_->watches()) time_.clock().pause(true);
    skip_wait();
    return {};
}

Outcome<std::optional<Recorder>> App::begin_recording(const Scenario& scenario,
                                                      const std::optional<std::filesystem::path>& wanted) {
    const auto path = wanted ? Outcome<std::filesystem::path>(*wanted) : next_recording(scenario.scene);
    auto recorder = path ? record_into(*path, scenario) : Outcome<Recorder>(tl::unexpected(path.error()));
    // A file given with --record must be writable. The default recording is optional.
    if (!recorder && wanted) return tl::unexpected(recorder.error());
    if (!recorder) {
        warn(said("This session is not recorded: {}", recorder.error().sentence));
        return std::nullopt;
    }
    return std::move(*recorder);
}

}  // namespace game
