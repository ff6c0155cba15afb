#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "game/app/best_list.h"
#include "game/app/challenge_maker.h"
#include "game/app/dam_lines.h"
#include "game/app/filming.h"
#include "game/app/ghost.h"
#include "game/app/goal_lines.h"
#include "game/app/languages.h"
#include "game/app/lesson_run.h"
#include "game/app/measuring.h"
#include "game/app/photo_mode.h"
#include "game/app/results.h"
#include "game/app/screenshots.h"
#include "game/app/session_file.h"
#include "game/app/session_picture.h"
#include "game/app/settings.h"
#include "game/app/sharing.h"
#include "game/app/shown_runs.h"
#include "game/app/slide_labels.h"
#include "game/app/sounds.h"
#include "game/app/time_marks.h"
#include "game/app/tutorial.h"
#include "game/app/world_image.h"
#include "game/base/outcome.h"
#include "game/controls/action.h"
#include "game/controls/catalogue.h"
#include "game/controls/display.h"
#include "game/controls/frame_clock.h"
#include "game/controls/gamepad.h"
#include "game/controls/hand.h"
#include "game/controls/input.h"
#include "game/controls/lookout.h"
#include "game/controls/notices.h"
#include "game/controls/path_maker.h"
#include "game/controls/probe.h"
#include "game/controls/screen.h"
#include "game/controls/shots.h"
#include "game/controls/slide_front.h"
#include "game/controls/time_control.h"
#include "game/session/sandbox.h"
#include "game/ui/ui.h"
#include "render/frame/marks.h"

namespace game {

// The interactive sandbox on a screen: a world, its image, user input and panels. Owns everything that
// outlives a frame.
class App {
  public:
    // Starts with `loaded` on a screen that outlives the app; `record` as in begin_world. Errors: shaders or
    // assets are missing, or `record` cannot be written (3). Without a `tier`, the first frames measure which
    // one suits the machine. `led`: how far the tutorial has got; at its first step `loaded` is its opening slide.
    // `settings`: what it begins with and where it keeps what a person changes. `languages`: among which a person can choose.
    static Outcome<std::unique_ptr<App>> begin(Screen& screen, LoadedWorld loaded,
                                               const sim::StepOptions& options,
                                               const std::optional<std::filesystem::path>& record,
                                               std::optional<Tier> tier = std::nullopt,
                                               const std::optional<Remembered>& led = std::nullopt,
                                               SettingsFile settings = {}, Languages languages = {});
    ~App();

    // Runs one frame, from events to the image on the screen. False once the user has asked to quit, or if the image
    // failed.
    bool frame();
    // Plays a recording up to this tick and takes it over there.
    void take_over_at(std::int64_t tick);
    // Shows the menu, as the first thing that is seen.
    void begin_menu();
    // Shows runs over their world, which is open, until a world of another ground is.
    void show_runs(Runs runs);
    // Closes the recording. Errors: it cannot be written (3).
    Outcome<void> finish();

    const Sandbox& sandbox() const { return *sandbox_; }
    const FrameTimes& times() const { return frames_.times(); }
    const WorldImage& image() const { return image_; }
    const Notices& notices() const { return notices_; }
    const TickClock& clock() const { return time_.clock(); }
    const Brush& brush() const { return hand_.brush(); }
    const std::optional<Guide>& guide() const { return tutorial_.guide(); }
    const Display& display() const { return display_; }
    const PhotoMode& photo() const { return photo_; }
    const Catalogue& catalogue() const { return catalogue_; }
    // Of the challenge that is open, the best first.
    const std::vector<BestRun>& best_runs() const { return best_list_.runs(); }
    const render::Camera& camera() const { return lookout_.camera(); }
    const ui::Ui& panels() const { return ui_; }
    const Ghost& ghost() const { return ghost_; }
    const PathMaker& path() const { return path_; }
    const std::optional<ShownRuns>& runs() const { return runs_; }
    bool is_making_challenge() const { return maker_.is_busy(); }
    const std::optional<LessonRun>& lesson() const { return open_.lesson; }
    bool is_filming() const { return filming_.progress().has_value(); }
    bool is_sharing() const { return sharing_.progress().has_value(); }
    // The file that this session is written to; nothing while a recording is watched, if none could be created,
    // or if writing failed.
    const std::optional<std::filesystem::path>& recording() const { return file_.path(); }
    // Why a file of this or of an earlier session could not be written completely; the first failure.
    const std::optional<Failure>& recording_failure() const { return file_.failure(); }

  private:
    App(Screen& screen, render::Renderer renderer, Catalogue catalogue, const sim::StepOptions& options);

    // The stages of a frame, in order.
    std::span<const Event> poll(double elapsed_s);
    void perform_all();
    void move_camera(double elapsed_s);
    void preview_path(double elapsed_s);
    void guide_stroke();
    void focus_photo();
    void run_ticks(double elapsed_s, FrameTime& time);
    bool works_in_pause(double tick_s);
    void seek(std::int64_t tick, double begun_s);
    void draw_world(const FrameTime& time);
    void draw_panels();
    void play_sound(int ticks);
    void speak_as_chosen();
    void begin_as_kept(SettingsFile settings, std::optional<Tier> tier);
    const Settings& settings_now();
    void take_screenshot();
    void keep_picture(Outcome<render::Picture> picture);
    std::span<const Event> watch_opening(std::span<const Event> events);
    void end_opening();
    void lead();
    void begin_tutorial(const Remembered& led);

    render::Marks marks() const;
    void show_hand(render::Marks& marks) const;
    WorldImage::Subject subject() const;

    void perform(Verb verb);
    void perform(Tool tool);
    void perform(const SetSpeed& set);
    void perform(const SeekTick& seek);
    void perform(const SetBrush& set);
    void perform(const SetNumber& set);
    void perform(const SetDisplay& set);
    void perform(const Open& open);
    void perform(const LookAt& wish);
    void perform(const SeeFromFront& wish);
    void perform(const GuideWish& wish);
    void perform(const SaveWorld& wish);
    void perform(const MakeChallenge&);
    void perform(const TryChallenge&);
    void perform(const ChallengeFriend&);
    void perform(const CoverGround& wish);
    void perform(const BindKey& wish);
    void perform(const ResetKeys&);
    void perform(const SetPhoto& set);
    void perform(const FilmSlide& wish);
    void perform(const RenameFile& wish);
    void perform(const ThrowAway& wish);
    void perform(const ShowFile& wish);
    bool is_in_use(const std::filesystem::path& file);  // true: said so
    void perform(const StopFilm&);
    void perform(const EditPath& wish);
    void go_to_key(std::size_t key);
    std::int64_t tick_of(const CameraKey& key) const;
    void play_path();
    void save_path();
    void load_path();
    Outcome<std::filesystem::path> path_file() const;
    void perform(const DrawSection& wish);
    void perform(const LessonWish& wish);
    bool perform_in_photo(Verb verb);  // false: as always
    void begin_photo();
    void end_photo();
    void pause(bool on);
    void undo();
    void redo();
    void list_own();
    void put_picture(const std::filesystem::path& recording, const render::Picture& small);
    void stop_hand();
    void reset();
    void share();
    void share(Outcome<std::string> recording);
    void tell_results();
    void tell_made();
    void tell_film();
    void picture_session();
    void judge_attempt();
    void keep_run(const Score& score);
    void judge_slides();
    void see_ghost();
    bool has_card() const;
    void fit_hand();
    void trace_goal();
    void trace_dam();
    void trace_runs();
    bool begin_section();  // false: the press is no part of it
    void draw_section(const std::optional<glm::dvec3>& at);
    void measure();
    void label_slide();
    void open_run(std::int64_t run);
    render::Camera home() const;
    void tell_camera_mode();
    void begin_stroke();
    void tell_of_bare_ground(glm::dvec2 at);
    std::optional<ui::StrokeNote> stroke_note() const;
    std::optional<ui::PhotoNote> photo_note() const;
    bool on_slope_of_brush(glm::dvec2 at) const;
    double earth_used() const;  // m³
    void keep_watched_run(const Score& score);
    void take_over_at_end();
    void take_over();
    bool may_go_back();  // false: shows a notice with the reason
    void step_back();
    void skip();
    std::int64_t shortly_before() const;  // tick
    void go_to_mark(const std::optional<std::int64_t>& tick);
    void run_back();
    void tell_hands_off();
    // A past or a lesson is looked at.
    bool is_read_only() const { return sandbox_->looks_back() || open_.lesson; }
    void see_lesson();
    void go_on_with_lesson();
    void guess_in_lesson();
    void trace_lesson();

    // Another world, whose time is neither paused nor at another speed.
    Outcome<void> begin_afresh(LoadedWorld loaded);
    // Replaces the world by `loaded`, recorded in `record` or else in the recordings folder, and closes the
    // previous world. `backdrop`: mountains and woods of `loaded`, if they are known. Errors: `record` cannot be written, and
    // then nothing has changed.
    Outcome<void> begin_world(LoadedWorld loaded, std::optional<std::filesystem::path> record,
                              std::optional<Backdrop> backdrop = std::nullopt);
    Outcome<std::optional<Recorder>> begin_recording(const Scenario& scenario,
                                                     const std::optional<std::filesystem::path>& wanted);
    bool open_or_tell(const std::string& name_or_path, const Overrides& overrides);  // false: it was refused
    Outcome<void> close_recording();

    double now_s() const { return frames_.now_s(); }
    Keys keys() const { return {screen_.layout(), now_set_.keys, gamepad_.in_use()}; }
    void skip_wait() { frames_.skip_to(screen_.seconds()); }  // it must not be simulated
    void tell(std::string sentence) { notices_.tell(Notice::Kind::kInfo, std::move(sentence), now_s()); }
    void warn(std::string sentence) {
        notices_.tell(Notice::Kind::kWarning, std::move(sentence), now_s());
        sounds_.note(sound::Wave::kRefusal);
    }

    // What belongs to the open world alone, made anew with the next one.
    struct OpenWorld {
        std::optional<Probe> probe;
        SlideFront front;
        std::optional<Shots> shots;  // while the opening is watched
        double earth_before = 0;     // m³ in use when the stroke began
        Results results;
        GoalLines goal_lines;
        DamLines dam_lines;
        Measuring measuring;
        SlideLabels slide_labels;
        std::optional<ui::GhostNote> ghost_note;  // of the ghost as it is shown
        SessionPicture picture;
        TimeMarks marks;
        std::optional<LessonRun> lesson;  // of first_
        std::vector<ui::LessonMark> lesson_marks;
        bool skips = false;  // to the end of the slide
    };

    Screen& screen_;
    Notices notices_;
    WorldImage image_;
    ui::Ui ui_;
    Catalogue catalogue_;
    std::string renderer_name_;
    sim::StepOptions options_;

    LoadedWorld first_;  // restored by reset
    std::optional<Sandbox> sandbox_;
    OpenWorld open_;
    SessionFile file_;

    FrameClock frames_;
    TimeControl time_;
    Actions actions_;
    Hand hand_;
    Display display_;
    SettingsFile settings_;
    Settings now_set_;  // settings_now()
    Languages languages_;
    std::optional<std::string> spoken_;  // of the display, when the language was chosen
    Input input_{now_set_.keys};
    Gamepad gamepad_;
    std::vector<Event> events_;  // of a frame in which there is a gamepad
    Lookout lookout_;
    bool leaving_ = false;

    BestList best_list_;
    Ghost ghost_;
    std::optional<ShownRuns> runs_;

    Tutorial tutorial_;
    Sounds sounds_;

    PhotoMode photo_;
    Screenshots screenshots_;
    Sharing sharing_;
    Filming filming_;
    PathMaker path_;
    ChallengeMaker maker_;
};

}  // namespace game
