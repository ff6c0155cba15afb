#include "game/app/app.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <future>
#include <utility>

#include <fmt/format.h>
#include <glm/geometric.hpp>

#include "game/controls/key_map.h"
#include "game/files/assets.h"
#include "game/files/recordings_folder.h"
#include "game/files/ui_font.h"
#include "game/files/user_folders.h"
#include "game/scene/surface.h"
#include "game/scene/viewpoint.h"
#include "game/words/plain.h"
#include "game/words/words.h"
#include "render/mountain/overview.h"
#include "render/mountain/pick.h"
#include "sim/world/disc.h"
#include "sim/world/on_ground.h"

namespace game {
namespace {

constexpr double kTickBudget = 0.04;             // s per frame; more would make the display stutter
constexpr double kSkipBudget = 0.15;             // s per frame, while the end is all that is asked for
constexpr int kSkippedTicks = 600;               // in a frame, at most
constexpr double kOpeningSpeed = 2;              // ×
constexpr glm::dvec2 kPlaceToClick(1325, 1775);  // m, on the guide's mountain: where a small blast does most

// Milliseconds since the last call.
class Stopwatch {
  public:
    explicit Stopwatch(const Screen& screen) : screen_(screen), last_(screen.seconds()) {}
    float lap() {
        const double before = std::exchange(last_, screen_.seconds());
        return static_cast<float>(1000 * (last_ - before));
    }

  private:
    const Screen& screen_;
    double last_;
};

}  // namespace

Outcome<std::unique_ptr<App>> App::begin(Screen& screen, LoadedWorld loaded, const sim::StepOptions& options,
                                         const std::optional<std::filesystem::path>& record,
                                         std::optional<Tier> tier, const std::optional<Remembered>& led,
                                         SettingsFile settings, Languages languages) {
    const auto assets = assets_folder();
    if (!assets) return tl::unexpected(assets.error());
    auto catalogue = read_catalogue();
    if (!catalogue) return tl::unexpected(catalogue.error());
    // Beside the shaders, which take as long.
    auto backdrop = std::async(std::launch::async, backdrop_of, std::cref(loaded.scene.scenario));
    auto renderer = render::Renderer::create(*assets, render::Quality::kFast);
    if (!renderer) return machine_fails(renderer.error());

    std::unique_ptr<App> app(new App(screen, std::move(*renderer), std::move(*catalogue), options));
    app->skip_wait();
    app->renderer_name_ = screen.renderer_name();
    app->languages_ = std::move(languages);
    app->begin_as_kept(std::move(settings), tier);
    if (auto begun = app->begin_world(std::move(loaded), record, backdrop.get()); !begun)
        return tl::unexpected(begun.error());
    if (led) app->begin_tutorial(*led);
    if (screen.has_sound()) app->sounds_.begin(screen.seconds());
    return app;
}

App::App(Screen& screen, render::Renderer renderer, Catalogue catalogue, const sim::StepOptions& options)
    : screen_(screen),
      image_(screen, notices_, std::move(renderer)),
      ui_(ui_font()),
      catalogue_(std::move(catalogue)),
      options_(options),
      lookout_(screen, display_) {}

App::~App() {
    speak(nullptr);
    speak_plainly(false);
}

// `tier`: of the command line.
void App::begin_as_kept(SettingsFile settings, std::optional<Tier> tier) {
    settings_ = std::move(settings);
    now_set_ = settings_.begun();
    display_ = now_set_.display;
    if (!settings_.told().empty()) warn(settings_.told());
    for (const std::string& told : languages_.told()) warn(told);
    speak_as_chosen();
    if (!tier) tier = now_set_.tier;
    if (tier)
        display_.tier = *tier;
    else
        image_.begin_trial(display_.frame_ms);
}

void App::speak_as_chosen() {
    speak_plainly(!display_.field_words);
    if (std::exchange(spoken_, display_.language) == display_.language) return;
    languages_.choose(display_.language);
}

// As a person has left them until now. Of a full screen, the size of the window before.
const Settings& App::settings_now() {
    now_set_.display = display_;
    now_set_.fullscreen = screen_.fullscreen();
    const ScreenSize size = screen_.size();
    if (now_set_.fullscreen || size.width == 0) return now_set_;
    const auto side = [&](int pixels) {
        return std::clamp(static_cast<int>(std::lround(pixels / size.scale)), Settings::kLeastSide,
                          Settings::kMostSide);
    };
    now_set_.width = side(size.width), now_set_.height = side(size.height);
    return now_set_;
}

bool App::frame() {
    const double elapsed_s = frames_.begin(screen_.seconds());
    FrameTime time;
    Stopwatch watch(screen_);

    // Input first, so that its effect is seen in this frame; panels before the world, because they lie on
    // top.
    const auto events = watch_opening(poll(elapsed_s));
    const ScreenSize size = screen_.size();
    speak_as_chosen();
    ui_.begin(events, screen_, display_.letters, elapsed_s);
    input_.take(events, size, {ui_.keeps_mouse(), ui_.keeps_keys()}, actions_);
    input_.add(gamepad_.turn(), gamepad_.walk());
    perform_all();
    tell_results();
    open_.marks.forget_after(sandbox_->known_until());

    // The camera before the brush: the brush is where the cursor meets the ground in the new view.
    if (size.width > 0) move_camera(elapsed_s);
    guide_stroke();
    time.stage_ms[stage_index(Stage::kInput)] = watch.lap();

    // Ticks that are due, each with the user's commands: recorded first, then applied. None behind the menu and for a photo.
    if (!ui_.shows_menu() && !photo_.is_on()) run_ticks(elapsed_s, time);
    see_lesson();
    time.stage_ms[stage_index(Stage::kSolve)] = watch.lap();

    lead();
    play_sound(time.ticks);
    if (size.width > 0) {
        // The world after its ticks, then the panels, which describe the same tick.
        draw_world(time);
        if (image_.failure()) return false;
        if (time.ticks > 0) picture_session();
        time.stage_ms[stage_index(Stage::kDraw)] = watch.lap();
        draw_panels();
        time.stage_ms[stage_index(Stage::kPanels)] = watch.lap();
        screen_.present();
        time.stage_ms[stage_index(Stage::kPresent)] = watch.lap();
        // Last, of the world that was just shown.
        if (screenshots_.asked()) take_screenshot();
        if (auto photo = image_.photo_result()) keep_picture(std::move(*photo));
        if (image_.photo_progress()) skip_wait();
    }
    if (const auto kept = settings_.see(settings_now(), now_s()); !kept) warn(kept.error().sentence);
    frames_.end(time);
    return !leaving_ && !image_.failure();
}

Outcome<void> App::finish() {
    if (file_.wanted() && sandbox_->watches()) take_over();
    const auto kept = settings_.finish(settings_now());
    auto closed = close_recording();
    return closed ? kept : closed;
}

void App::begin_menu() {
    ui_.begin_menu();
}

void App::begin_tutorial(const Remembered& led) {
    if (!led.told.empty()) warn(led.told);
    skip_wait();
    tutorial_.begin(led, sandbox_->watches(), now_s());
    if (!tutorial_.shows_opening()) return;
    time_.clock().set_speed(kOpeningSpeed);
    open_.shots.emplace(lookout_.camera());
}

// While the slide of the opening is watched, any key or button ends it, and does nothing else.
std::span<const Event> App::watch_opening(std::span<const Event> events) {
    if (!tutorial_.shows_opening()) return events;
    if (tutorial_.opening_ends(events, sandbox_->session().seconds(), now_s())) end_opening();
    return tutorial_.without_presses(events);
}

// The same mountain, untouched.
void App::end_opening() {
    open_.shots.reset();
    open_or_tell(Guide::kMountain, {});
    lookout_.control().set_home(home());
    lookout_.control().overview();
    tutorial_.end_opening();
}

// Shows the hint that is due, and puts the tool of a new step into the hand.
void App::lead() {
    const auto begun = tutorial_.see(
        {.now_s = now_s(),
         .may_play = !tutorial_.shows_opening() && !photo_.is_on() && !sandbox_->watches() &&
                     !sandbox_->scenario().goal && !sandbox_->scenario().flow && !ui_.shows_menu(),
         .moves = sim::flows(sandbox_->session().state()) && !time_.pace().creeps(),
         .runs_back = time_.clock().runs_back(),
         .looks_back = sandbox_->looks_back()});
    if (!begun) return;
    sounds_.note(sound::Wave::kHint);
    if (*begun == Guide::Step::kBlast) hand_.choose(Tool::kBlast);
    if (const auto kept = tutorial_.keep(); !kept) warn(kept.error().sentence);
}

// What happened to the screen, and what a hand on a gamepad does as if it had a mouse.
std::span<const Event> App::poll(double elapsed_s) {
    const auto polled = screen_.poll();
    const auto& pad = screen_.pad();
    if (!pad && !gamepad_.is_there()) return polled;
    if (!gamepad_.is_there())
        tell(said("Gamepad: {}. Keys in the menu shows what its buttons do", screen_.pad_name()));
    if (!pad) tell(tr("The gamepad is gone. Mouse and keys work as before"));
    events_.assign(polled.begin(), polled.end());
    if (!events_.empty()) gamepad_.yield();
    gamepad_.take(pad,
                  {.screen = screen_.size(),
                   .flies = lookout_.control().mode() == CameraMode::kFly,
                   .in_panels = ui_.shows_menu(),
                   .elapsed_s = elapsed_s},
                  events_, actions_);
    return events_;
}

void App::perform_all() {
    if (input_.close_asked()) leaving_ = true;
    if (input_.dropped())
        for (const auto& path : screen_.dropped()) open_or_tell(path.string(), {});
    // Panels requested these in the previous frame. Requests made here wait for the next frame.
    for (std::size_t i = 0; i < actions_.size(); ++i) {
        const bool fits =
            std::holds_alternative<Verb>(actions_[i]) || std::holds_alternative<SetPhoto>(actions_[i]);
        if (photo_.is_on() && !fits) continue;  // a tool, say
        std::visit([this](const auto& action) { perform(action); }, actions_[i]);
    }
    actions_.clear();
}

void App::move_camera(double elapsed_s) {
    if (image_.photo_progress()) return;
    const sim::View world = sandbox_->session().view();
    if (lookout_.control().mode() == CameraMode::kChase || open_.shots)
        open_.front.see(world);
    else
        open_.front.forget();
    if (open_.shots)
        if (const auto pose = open_.shots->next({.camera = lookout_.camera(),
                                                 .front = open_.front.front(),
                                                 .world = world,
                                                 .around = lookout_.surroundings(),
                                                 .aspect = lookout_.aspect(),
                                                 .now_s = now_s()}))
            lookout_.control().cut_to(*pose);
    if (photo_.is_on()) photo_.fit(lookout_.control(), lookout_.aspect());
    if (path_.plays() && !photo_.is_on()) return preview_path(elapsed_s);
    lookout_.move(input_, open_.front.front(), world, elapsed_s);
}

// The camera follows its path while time runs. It ends at the last key, or when the user moves the camera.
void App::preview_path(double elapsed_s) {
    const Session& session = sandbox_->session();
    lookout_.control().cut_to(
        CameraRoom(session.view(), lookout_.surroundings()).inside(path_.spline().at(session.seconds())));
    const render::Camera pose = lookout_.camera();
    lookout_.move(input_, std::nullopt, session.view(), elapsed_s);
    const bool is_over = !time_.target() && session.seconds() >= path_.spline().ends_s();
    if (is_over || !look_alike(lookout_.camera(), pose)) path_.stop();
}

void App::guide_stroke() {
    if (photo_.is_on()) return focus_photo();
    if (input_.resize_steps() != 0) hand_.resize(input_.resize_steps(), sandbox_->scenario().grid);
    fit_hand();
    if (input_.brush_pressed() && !begin_section()) begin_stroke();
    const auto released_at = input_.brush_released_at();
    const auto at =
        released_at ? lookout_.ground_under(*released_at, sandbox_->session().view()) : lookout_.ground();
    hand_.move_to(at ? std::optional<glm::dvec2>(*at) : std::nullopt);
    draw_section(at);
    if (!input_.brush_held()) hand_.release();  // a click shorter than a tick is still a stroke
}

// On what is clicked at.
void App::focus_photo() {
    if (!input_.brush_pressed() || photo_.settings().f_number <= 0 || image_.photo_progress()) return;
    if (const auto at = lookout_.land_under(input_.drag_from(), sandbox_->session().view()))
        photo_.focus_on(*at);
}

// A press that begins the line of the cross-section is no stroke; not even where there is no ground.
bool App::begin_section() {
    if (!open_.measuring.takes_press()) return false;
    const auto at = lookout_.ground_under(input_.drag_from(), sandbox_->session().view());
    if (at) open_.measuring.press(glm::dvec2(*at));
    return true;
}

void App::draw_section(const std::optional<glm::dvec3>& at) {
    const sim::View world = sandbox_->session().view();
    if (at) open_.measuring.move_to(glm::dvec2(*at), static_cast<double>(world.grid.dx), open_.probe->zero());
    if (!input_.brush_held()) open_.measuring.release();
}

// A challenge has its own tools and limits, and not every world takes water.
void App::fit_hand() {
    if (hand_.stroke()) return;
    const Scenario& scenario = sandbox_->scenario();
    if (scenario.goal)
        hand_.fit(*scenario.goal);
    else if (!is_offered(info_of(hand_.brush().tool), scenario, sandbox_->session().state()))
        hand_.choose(Tool::kPour);
}

void App::begin_stroke() {
    if (runs_)
        if (const auto run = runs_->pointed_at()) return open_run(*run);
    if (open_.lesson && open_.lesson->asks_guess()) return guess_in_lesson();
    if (is_read_only()) return tell_hands_off();
    if (sandbox_->scenario().flow)
        return tell(tr("Brushes do not work in a flow demo. Change its speeds in the Display panel"));
    // Where the button was pressed; the cursor may have moved on since.
    const sim::View world = sandbox_->session().view();
    const auto at = lookout_.ground_under(input_.drag_from(), world);
    if (!at) {
        if (lookout_.mountain_under(input_.drag_from(), world))
            tell(tr("Beyond the grid there is only scenery: brushes work inside its border"));
        return;
    }
    const double bedrock = between(square_under(world.grid, glm::dvec2(*at)), world.bedrock);
    hand_.press(input_.modifiers(), glm::dvec2(*at), bedrock + world.datum,
                static_cast<double>(world.grid.dx));
    open_.earth_before = earth_used();
    sandbox_->begin_action(std::string(tr(sim::info_of(hand_.stroke()->deed().kind).name)));
    tell_of_bare_ground(glm::dvec2(*at));
}

// Says why a stroke that takes or releases material does nothing.
void App::tell_of_bare_ground(glm::dvec2 at) {
    const Deed& deed = hand_.stroke()->deed();
    const bool releases = deed.kind == sim::CommandKind::kBlast, digs = deed.kind == sim::CommandKind::kDig;
    if (!releases && !digs) return;
    const sim::State& state = sandbox_->session().state();
    sim::Command disc;
    disc.x = at.x, disc.y = at.y, disc.radius = hand_.brush().radius;
    bool bare = true;
    sim::Disc(disc, state.grid.dx).each_vertex(state.grid, sim::Profile::kDisc, [&](int x, int y, double) {
        bare &= state.depth(x, y) <= 0 && (releases || state.rolling(x, y) <= 0);
    });
    if (!bare) return;
    tell(said("Nothing lies here that could be {}", tr(releases ? "released" : "dug away")));
}

double App::earth_used() const {
    const sim::View world = sandbox_->session().view();
    if (!world.things) return 0;
    return sandbox_->session().cubic_metres(sim::earth_used(*world.things));
}

bool App::on_slope_of_brush(glm::dvec2 at) const {
    const sim::State& state = sandbox_->session().state();
    sim::Command command;
    command.least_slope = hand_.brush().least_slope, command.most_slope = hand_.brush().most_slope;
    const Square square = square_under(state.grid, at);
    return sim::SlopeFilter(command).takes(state, square.x + (square.across.x >= 0.5),
                                           square.y + (square.across.y >= 0.5));
}

std::optional<ui::StrokeNote> App::stroke_note() const {
    const auto& stroke = hand_.stroke();
    const auto& ground = lookout_.ground();
    if (!stroke || !ground) return std::nullopt;
    const auto cursor = lookout_.on_screen(*ground);
    if (!cursor) return std::nullopt;
    const sim::View world = sandbox_->session().view();
    ui::StrokeNote note{.cursor = *cursor};
    if (const auto from = stroke->line_from()) note.length = glm::distance(*from, glm::dvec2(*ground));
    note.left_alone = sim::info_of(stroke->deed().kind).has_slope && !on_slope_of_brush(glm::dvec2(*ground));
    if (!takes(stroke->deed().kind, &sim::Command::rise)) return note;
    const double used = earth_used();
    note.earth = used - open_.earth_before;
    if (world.things && world.things->budget >= 0)
        note.earth_left = sandbox_->session().cubic_metres(world.things->budget) - used;
    return note;
}

// A tool acts in a pause too, and time moves for that alone: by one tick for what acts at once, and while the button
// is held for what acts all the time. True in the latter case.
bool App::works_in_pause(double tick_s) {
    if (!time_.clock().paused() || time_.clock().runs_back() || !hand_.stroke() || sandbox_->looks_back())
        return false;
    if (!hand_.would_act(tick_s)) {
        hand_.arrive(1);
        return false;
    }
    if (hand_.stroke()->deed().acts == Acts::kAllTheTime) return true;
    time_.clock().step_once();
    return false;
}

void App::run_ticks(double elapsed_s, FrameTime& time) {
    TickClock& clock = time_.clock();
    const double tick_s = static_cast<double>(sandbox_->scenario().params.tick_s);
    const sim::State& state = sandbox_->session().state();
    // An hour of weather is next, unless the hand acts.
    const auto is_calm = [&] { return sim::is_calm(state) && !hand_.stroke(); };
    time_.set_pace(now_s(), display_.slow_release, display_.fast_creep,
                   hand_.stroke() || sandbox_->scenario().flow);
    if (hand_.stroke() || clock.paused() || clock.runs_back() || time_.target()) open_.skips = false;
    const bool calm = is_calm();
    const bool works = works_in_pause(tick_s);
    const int by_clock = clock.ticks_due(elapsed_s, calm ? shown_seconds(state) : tick_s, works);
    int due = open_.skips ? kSkippedTicks : by_clock;
    if (open_.lesson && !clock.runs_back())
        due = static_cast<int>(std::min<std::int64_t>(due, open_.lesson->ticks_to_stop(state.tick)));
    const double begun = screen_.seconds();
    if (clock.runs_back() && !time_.target()) time_.rewind_to(state.tick - due);
    if (time_.target()) return seek(*time_.target(), begun);
    const auto may_go_on = [&](double spent) {
        return !sandbox_->watched_to_end() &&
               (time.ticks == 0 || (is_calm() == calm && spent < (open_.skips ? kSkipBudget : kTickBudget)));
    };
    for (double spent = 0; time.ticks < due && may_go_on(spent); ++time.ticks) {
        const auto commands = hand_.commands_of(time.ticks, due, tick_s, !sandbox_->looks_back());
        for (const sim::Command& each : commands) tutorial_.did(each.kind);
        if (const auto done = sandbox_->tick(commands); !done) {
            hand_.drop();  // else it would be refused in every tick
            warn(done.error().sentence);
            if (done.error().status == Failure::kMachine) file_.stop(done.error());
            if (done.error().status == Failure::kBadAnswer) {
                clock.pause(true);
                break;
            }
        }
        if (!open_.skips) sounds_.see(sandbox_->session(), sandbox_->last_commands());
        open_.marks.see(sandbox_->session(), sandbox_->last_commands());
        open_.measuring.see_tick(sandbox_->session(), sandbox_->known_until());
        judge_attempt();
        const double now = screen_.seconds() - begun;
        time.worst_tick_ms = std::max(time.worst_tick_ms, static_cast<float>(1000 * (now - spent)));
        spent = now;
    }
    const bool turned = is_calm() != calm;  // from weather to a flow, or back: what is next lasts otherwise
    if (!open_.skips && !turned) clock.ticks_undone(due - time.ticks);
    if (sim::at_rest(state) || turned || has_card()) open_.skips = false;
    if (time.ticks > 0) {
        hand_.arrive(static_cast<double>(time.ticks) / due);
        time_.pace().see(state, now_s());
        judge_slides();
    }
    if (time_.sees_again() && (has_card() || !sandbox_->looks_back()))
        time_.go_to(sandbox_->known_until());  // back to the present, once it has come to rest
    take_over_at_end();
}

// Opens the card of a stop at which time has arrived, and lets time stand still there.
void App::see_lesson() {
    if (!open_.lesson || time_.target() || time_.clock().runs_back()) return;
    if (!open_.lesson->see(sandbox_->session().state().tick)) return;
    if (!time_.clock().paused()) pause(true);
    if (!open_.lesson->lacks_figures()) return;
    open_.lesson->take(
        lesson_figures(sandbox_->scenario(), sandbox_->session(), sandbox_->opening().scene.commands));
    sounds_.note(sound::Wave::kHint);
    if (const auto& view = open_.lesson->open()->camera) {
        const double height = surface_height(sandbox_->session().view(), {view->east, view->north});
        lookout_.control().go_to(camera_of(*view, height, home()));
    }
}

// Where the button was pressed.
void App::guess_in_lesson() {
    const auto at = lookout_.ground_under(input_.drag_from(), sandbox_->session().view());
    if (at) open_.lesson->guess(glm::dvec2(*at));
}

// What was guessed, and at the end what came of it.
void App::trace_lesson() {
    if (!open_.lesson) return;
    open_.lesson_marks.clear();
    const sim::View world = sandbox_->session().view();
    const auto add = [&](const std::optional<glm::dvec2>& place, bool is_guess) {
        const auto at = place ? lookout_.seen_on_screen(*place, world) : std::nullopt;
        if (at) open_.lesson_marks.push_back({*at, is_guess});
    };
    add(open_.lesson->toe(), false);
    add(open_.lesson->guessed(), true);
}

// Scores an attempt at the moment at which it ends.
void App::judge_attempt() {
    const Score* const score = open_.results.judge_attempt(*sandbox_, best_list_.runs());
    if (!score) return;
    if (const auto claimed = sandbox_->claim(score->claim()); !claimed) file_.stop(claimed.error());
    if (score->won()) sounds_.note(sound::Wave::kMedal);
    keep_run(*score);
}

// Keeps the attempt that ended in this tick, if it may be among the best: one in which the user did something.
void App::keep_run(const Score& score) {
    if (sandbox_->watches()) return keep_watched_run(score);
    if (!score.meets_needs() || sandbox_->looks_back() || !sandbox_->was_touched()) return;
    const auto kept = sandbox_->recorded_so_far().and_then([&](const std::string& recorded) {
        return best_list_.keep(score, sandbox_->session().state_line().hash, recorded);
    });
    if (!kept) warn(said("This run is not among the best runs: {}", kept.error().sentence));
}

// The same of a recording that somebody else has made: once its states and its rules are proven.
void App::keep_watched_run(const Score& score) {
    const Recording& watched = *sandbox_->opening().watched;
    if (!score.meets_needs() || !watched.claim || sandbox_->verdict()->kind() != Verdict::Kind::kExact)
        return;
    if (const auto broken = broken_rule(sandbox_->scenario(), watched.commands, score.tick))
        return warn(said("This run is not among the best runs: {}", *broken));
    if (*watched.claim != score.claim())
        return warn(said("This run is not among the best runs: it claims a score of {}, and has {}",
                         watched.claim->score, score.points));
    const StateLine& now = sandbox_->session().state_line();
    const auto kept =
        recording_of_try(watched, sandbox_->opening().name, score, now)
            .and_then([&](const std::string& text) { return best_list_.keep(score, now.hash, text); });
    if (!kept) return warn(said("This run is not among the best runs: {}", kept.error().sentence));
    if (std::ranges::find(best_list_.runs(), now.hash, &BestRun::hash) != best_list_.runs().end())
        tell(said("Proven: a score of {}, {}. It counts among the best runs", score.points,
                  tr(medal_name(score.medal))));
}

bool App::has_card() const {
    return open_.results.card(*sandbox_) != nullptr;
}

// Says that a slide has come to rest, how to share it, and what it came to.
void App::judge_slides() {
    if (const auto lasted = open_.results.came_to_rest(*sandbox_))
        tell(said("The slide has come to rest after {:.0f} s. {} shares it as a web page", *lasted,
                  name_of(keys(), Verb::kShare)));
    if (const auto swept = open_.results.judge_slide(*sandbox_, time_.pace().creeps()))
        tell(said("Only {:.0f} m³ were swept along. Try it steeper: 40° or more", *swept));
}

// Of the world as it will be shown. In a pause and on the way to another time it is silent.
void App::play_sound(int ticks) {
    const Session& session = sandbox_->session();
    sound::Ear ear = sound::ear_of(camera(), session.view());
    ear.passes = ticks > 0 || !(time_.clock().paused() || time_.clock().runs_back() || time_.target() ||
                                ui_.shows_menu() || photo_.is_on());
    ear.looks = input_.focused();
    if (ticks > 0 && hand_.stroke() && hand_.stroke()->deed().acts == Acts::kAllTheTime)
        ear.scrapes = lookout_.ground();
    if (const auto lost = sounds_.play(session, ear, display_.volumes, screen_.seconds())) warn(*lost);
}

// Moves toward a known tick, as far as the time budget of the frame allows.
void App::seek(std::int64_t tick, double begun_s) {
    hand_.drop();
    const std::int64_t before = sandbox_->session().state().tick;
    const auto may_go_on = [&] {
        open_.measuring.see_tick(sandbox_->session(), sandbox_->known_until());
        return screen_.seconds() - begun_s < kTickBudget;
    };
    const auto there = sandbox_->go_toward(tick, may_go_on);
    if (!there) warn(there.error().sentence);
    if (sandbox_->session().state().tick != before) time_.jump();
    if (there && !*there && sandbox_->can_go_back()) return;  // continues in the next frame
    if (time_.arrive(sandbox_->session().state().tick)) take_over();
}

// Hands a watched recording over to the user at its end.
void App::take_over_at_end() {
    if (!sandbox_->watched_to_end() || open_.lesson) return;
    time_.clock().set_speed(1);  // the user may have watched at a higher speed
    const Verdict verdict = *sandbox_->verdict();
    const bool proven = verdict.proven_tick == sandbox_->known_until();
    take_over();
    open_.results.set_may_share(true);
    if (verdict.parted)
        warn(said("End of the recording. Its replay differs: {}. You can continue from here",
                  *verdict.parted));
    else if (!verdict.comparable)
        tell(tr(
            "End of the recording. It was made by another physics version, so states were not compared. You "
            "can continue from here"));
    else if (!proven)
        tell(
            tr("End of the recording. It has no state up to its end to compare with. You can continue from "
               "here"));
    else
        tell(
            said("End of the recording, replayed bit for bit. You can continue from here; {} shares "
                 "it as a web page",
                 name_of(keys(), Verb::kShare)));
}

// A ring around what the tool reaches, or the outline of what it is about to place.
void App::show_hand(render::Marks& marks) const {
    const glm::dvec2 at(*lookout_.ground());
    const Brush& brush = hand_.brush();
    const Deed& deed = hand_.deed(input_.modifiers());
    const double width = number_of(brush, &sim::Command::width),
                 cell = static_cast<double>(sandbox_->scenario().grid.dx);
    if (const auto from = hand_.stroke() ? hand_.stroke()->line_from() : std::nullopt; from && *from != at) {
        marks.outline = render::Outline{*from, at, std::max(width, cell / 4), false, deed.ring};
    } else if (deed.acts == Acts::kAndTurns) {
        if (!hand_.stroke())
            marks.outline =
                render::outline_of(at, brush.turn, number_of(brush, &sim::Command::length), width, deed.ring);
    } else {
        marks.ring = render::Ring{at, ring_radius(brush, deed, sandbox_->scenario().grid), deed.ring};
    }
}

// Where the best run was at this time of its try.
void App::see_ghost() {
    const auto& goal = sandbox_->scenario().goal;
    const auto action =
        goal && !goal->events.empty() ? std::optional<std::int64_t>(0) : sandbox_->first_action();
    const bool wanted = goal && display_.ghost && action && !sandbox_->watches();
    const Session& session = sandbox_->session();
    const std::int64_t before = ghost_.version();
    ghost_.see(wanted ? session.state().tick - *action : -1);
    while (const auto fault = ghost_.fault()) warn(said("A best run is not shown: {}", *fault));
    if (ghost_.version() == before) return;
    const auto hectares = [&](std::ptrdiff_t vertices) {
        constexpr double kHectare = 1e4;  // m²
        const auto dx = static_cast<double>(session.state().grid.dx);
        return static_cast<double>(vertices) * dx * dx / kHectare;
    };
    open_.ghost_note.reset();
    if (ghost_.version() == 0) return;
    const auto& deepest = session.peaks().depth;
    open_.ghost_note = {
        hectares(std::ranges::count_if(deepest, [](float depth) { return depth >= RunExtent::kReached; })),
        hectares(std::ranges::count_if(ghost_.inside(), [](std::uint8_t in) { return in != 0; }))};
}

render::Marks App::marks() const {
    render::Marks marks{.overlay = display_.overlay,
                        .contours = display_.contours,
                        .flow_mesh = display_.flow_mesh,
                        .extent = ghost_.version(),
                        .probability = runs_ ? runs_->version() : 0};
    if (const auto& densities = sandbox_->session().densities())
        marks.density = glm::dvec2(densities->upper, densities->lower);
    if (photo_.is_on()) marks.extent = 0;
    if (tutorial_.shows_opening() || photo_.is_on()) return marks;
    const bool wanted = (!ui_.hides_panels() && !open_.measuring.takes_press()) ||
                        hand_.stroke();  // without panels the image is for looking
    if (lookout_.ground() && wanted && !is_read_only() && !sandbox_->scenario().flow) show_hand(marks);
    return marks;
}

WorldImage::Subject App::subject() const {
    return {*sandbox_,       lookout_.surroundings(),
            lookout_.land(), lookout_.woods(),
            ghost_.inside(), runs_ ? runs_->probability() : std::span<const float>()};
}

void App::draw_world(const FrameTime& time) {
    see_ghost();
    WorldImage::Seen seen{time_.epoch(), sandbox_->session().changed_at(), camera(), display_, marks(),
                          screen_.size()};
    if (photo_.is_on())
        seen.display.light = photo_.light(), seen.lens = photo_.lens(camera(), lookout_.aspect());
    image_.draw(seen, subject(), {now_s(), time, times()});
    display_.tier = image_.tier();
}

// Keeps the image of the moment at which most moves, for the list of recordings.
void App::picture_session() {
    const std::int64_t moving = sandbox_->session().state().ledger.rolling;
    if (!sandbox_->watches() && file_.path() && open_.picture.see(moving)) open_.picture.take(image_.shown());
}

// Of the world as last shown. A large photo is drawn in the next frames.
void App::take_screenshot() {
    const int times = photo_.is_on() ? photo_.settings().times : 1;
    if (image_.photo_progress()) return;
    if (times == 1) return keep_picture(image_.picture(subject()));
    if (const auto begun = image_.begin_photo(times); !begun)
        warn(said("No screenshot: {}", begun.error().sentence));
}

void App::keep_picture(Outcome<render::Picture> picture) {
    display_.tier = image_.tier();
    if (image_.failure()) return;
    if (!picture) return warn(said("No screenshot: {}", picture.error().sentence));
    file_.keep();
    Shot shot{sandbox_->scenario(), file_.path().value_or(""), sandbox_->session().state().tick, camera()};
    if (sandbox_->watches()) shot.recording = first_.name + ".couloir";
    if (photo_.is_on()) shot.photo = photo_.settings(), shot.focus_m = photo_.focus_m(camera());
    const auto begun =
        screenshots_.write(std::move(*picture), dated_name(shot.scenario.scene), texts_of(shot));
    if (!begun) warn(said("No screenshot: {}", begun.error().sentence));
    skip_wait();
}

std::optional<ui::PhotoNote> App::photo_note() const {
    if (!photo_.is_on()) return std::nullopt;
    return ui::PhotoNote{photo_.settings(), focal_lengths(lookout_.aspect()), photo_.hour(),
                         screen_.size(),    image_.photo_progress(),          photo_.focus_m(camera())};
}

// Follows the surface once per second of the world.
void App::trace_goal() {
    const auto& goal = sandbox_->scenario().goal;
    if (!goal || ui_.hides_panels()) return;
    const ScreenSize size = screen_.size();
    const sim::View world = sandbox_->session().view();
    open_.goal_lines.trace(
        *goal, world.grid,
        {camera(), size.width, size.height, static_cast<std::int64_t>(sandbox_->session().seconds())},
        {sandbox_->session().state().tick, static_cast<double>(sandbox_->scenario().params.tick_s)},
        [&](glm::dvec2 place) { return lookout_.seen_on_screen(place, world); },
        [&](const Quantity& quantity) {
            return amount_in_area(sandbox_->scenario(), sandbox_->session(), quantity);
        });
}

// While a tool for earth is in hand.
void App::trace_dam() {
    const sim::CommandKind kind = hand_.deed(input_.modifiers()).kind;
    const bool moves_earth = kind == sim::CommandKind::kSculpt || kind == sim::CommandKind::kSmooth ||
                             kind == sim::CommandKind::kLevel;
    const auto& ground = lookout_.ground();
    if (!moves_earth || !ground || ui_.hides_panels()) return open_.dam_lines.clear();
    const Session& session = sandbox_->session();
    const sim::View world = session.view();
    const ScreenSize size = screen_.size();
    const Square square = square_under(world.grid, glm::dvec2(*ground));
    open_.dam_lines.trace(
        world,
        {camera(), size.width, size.height, square.x, square.y, world.things ? world.things->changed : 0},
        [&](std::int64_t quanta) { return session.cubic_metres(quanta); },
        [&](glm::dvec2 place) { return lookout_.seen_on_screen(place, world); },
        [&](glm::dvec3 place) { return lookout_.on_screen(place); });
}

// The ends follow the surface once per second of the world.
void App::trace_runs() {
    if (!runs_) return;
    if (!display_.ends || ui_.hides_panels()) return runs_->point_nowhere();
    const ScreenSize size = screen_.size();
    const Session& session = sandbox_->session();
    runs_->trace({camera(), size.width, size.height, static_cast<std::int64_t>(session.seconds())},
                 [&](glm::dvec2 place) { return lookout_.seen_on_screen(place, session.view()); });
    const auto cursor = input_.cursor();
    if (cursor && !hand_.stroke())
        runs_->point_at({(cursor->x + 1) / 2 * size.width, (1 - cursor->y) / 2 * size.height});
    else
        runs_->point_nowhere();
}

// While its panel is open.
void App::measure() {
    if (!ui_.shows_measures()) return open_.measuring.wait_for_line(false);
    const Session& session = sandbox_->session();
    open_.measuring.see(session, sandbox_->known_until());
    const ScreenSize size = screen_.size();
    open_.measuring.trace({camera(), size.width, size.height, static_cast<std::int64_t>(session.seconds())},
                          [&](glm::dvec2 place) { return lookout_.seen_on_screen(place, session.view()); });
}

void App::label_slide() {
    if (!display_.labels) return;
    const ScreenSize size = screen_.size();
    const sim::View world = sandbox_->session().view();
    open_.slide_labels.trace(
        *sandbox_, {camera(), size.width, size.height, time_.epoch()},
        [&](glm::dvec2 place) { return lookout_.seen_on_screen(place, world); },
        [&](glm::dvec2 point) { return lookout_.land_under(point, world); });
}

void App::draw_panels() {
    const Session& session = sandbox_->session();
    trace_goal();
    trace_dam();
    trace_runs();
    trace_lesson();
    measure();
    label_slide();
    std::optional<Reading> reading;
    if (const auto& ground = lookout_.ground())
        reading = open_.probe->read(session.view(), glm::dvec2(*ground));
    const ui::Timeline timeline{.known_until = sandbox_->known_until(),
                                .watches = sandbox_->watches(),
                                .can_go_back = sandbox_->can_go_back()};
    std::optional<glm::dvec2> place_to_click;
    const auto& guide = tutorial_.guide();
    if (guide && guide->shows_place())
        place_to_click = lookout_.on_screen({kPlaceToClick, surface_height(session.view(), kPlaceToClick)});
    std::optional<glm::dvec2> ground;
    if (lookout_.ground()) ground = glm::dvec2(*lookout_.ground());
    ui_.build(
        {
            .scenario = sandbox_->scenario(),
            .state = session.state(),
            .clock = time_.clock(),
            .brush = hand_.brush(),
            .deed = hand_.deed(input_.modifiers()),
            .brushing = hand_.stroke().has_value(),
            .touched = hand_.has_acted(),
            .stroke = stroke_note(),
            .goal_use = sandbox_->scenario().goal ? std::optional(sandbox_->goal_use()) : std::nullopt,
            .goal_lines = open_.goal_lines.lines(),
            .goal_events = open_.goal_lines.events(),
            .goal_counts = open_.goal_lines.counts(),
            .dam_lines = open_.dam_lines.lines(),
            .dam = open_.dam_lines.note(),
            .card = open_.results.card(*sandbox_),
            .ghost = open_.ghost_note,
            .runs = runs_ ? std::optional(runs_->note(ground)) : std::nullopt,
            .section = ui_.shows_measures() ? std::optional(open_.measuring.note()) : std::nullopt,
            .history = ui_.shows_measures() ? &open_.measuring.history() : nullptr,
            .houses = ui_.shows_measures() ? open_.measuring.houses() : std::span<const ui::HouseMark>(),
            .slide_labels = display_.labels ? open_.slide_labels.labels() : std::span<const ui::SlideLabel>(),
            .compass = display_.labels ? open_.slide_labels.compass() : std::nullopt,
            .lesson = open_.lesson ? open_.lesson->note() : std::nullopt,
            .lesson_marks = open_.lesson_marks,
            .best_runs = best_list_.runs(),
            .actions_to_undo = sandbox_->actions(),
            .actions_to_redo = sandbox_->undone(),
            .under_cursor = reading,
            .camera_mode = lookout_.control().mode(),
            .display = display_,
            .times = times(),
            .notices = notices_,
            .catalogue = catalogue_,
            .keys = keys(),
            .gamepad = gamepad_.is_there() ? &gamepad_ : nullptr,
            .timeline = timeline,
            .time_marks = open_.marks.all(),
            .skips = open_.skips,
            .in_lesson = open_.lesson.has_value(),
            .recording = file_.path() ? std::string_view(file_.path()->native()) : std::string_view(),
            .renderer = renderer_name_,
            .sound_fault = sounds_.fault(),
            .languages = languages_.choices(),
            .now_s = now_s(),
            .image = image_.size(),
            .sharing = sharing_.progress(),
            .filming = filming_.progress(),
            .path = {path_.keys(), path_.plays(), session.seconds()},
            .photo = photo_note(),
            .making_challenge = maker_.is_busy(),
            .may_try = first_.watched && first_.scene.scenario.goal,
            .slide_ended = open_.results.may_share(),
            .guide = guide ? &*guide : nullptr,
            .opening_s = tutorial_.opening_s(now_s()),
            .place_to_click = place_to_click,
        },
        actions_);
    ui_.draw();
}

}  // namespace game
