#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <glm/vec2.hpp>

#include "game/analysis/best_runs.h"
#include "game/analysis/lesson_figures.h"
#include "game/analysis/slide_history.h"
#include "game/analysis/slide_parts.h"
#include "game/controls/brush.h"
#include "game/controls/camera_control.h"
#include "game/controls/catalogue.h"
#include "game/controls/cross_section.h"
#include "game/controls/display.h"
#include "game/controls/frame_times.h"
#include "game/controls/gamepad.h"
#include "game/controls/guide.h"
#include "game/controls/image_size.h"
#include "game/controls/key_map.h"
#include "game/controls/notices.h"
#include "game/controls/photo.h"
#include "game/controls/probe.h"
#include "game/controls/tick_clock.h"
#include "game/scene/scenario.h"
#include "game/words/language.h"
#include "sim/world/state.h"

namespace game::ui {

// The extent of the known time, before and after the current tick.
struct Timeline {
    std::int64_t known_until = 0;  // tick
    bool watches = false;          // a recording is being watched and has not been taken over
    bool can_go_back = true;
};

// A moment on the timeline that one can jump to.
struct TimeMark {
    enum class Kind : std::uint8_t { kAction, kHit, kStop };
    std::int64_t tick = 0;
    Kind kind = Kind::kAction;
    const char* word = "";  // a literal
};

// What the stroke in progress is about, told beside the cursor.
struct StrokeNote {
    glm::dvec2 cursor{0};                   // px from the top left
    std::optional<double> length = {};      // m, of the line that it draws
    std::optional<double> earth = {};       // m³ that the stroke uses; negative: gives back
    std::optional<double> earth_left = {};  // m³, if there is a budget
    bool left_alone = false;                // the ground there is outside the slopes of the brush
};

// What the user's slide and the ghost of the best run have reached by now, ha.
struct GhostNote {
    double own = 0, best = 0;
};

// The part of the ground around a slide, from above, north up.
struct SlideMap {
    int width = 0, height = 0;                // px
    std::vector<std::uint8_t> texels;         // red, green, blue; from the top row down
    glm::dvec2 south_west{0}, north_east{0};  // m, its corners
    double fastest = 0;                       // m/s, the top speed on it
    struct Mark {
        glm::dvec2 at{0};  // m
        enum class Kind : std::uint8_t { kCommand, kIntact, kDamaged, kDestroyed } kind = Kind::kCommand;
    };
    std::vector<Mark> marks;  // what the user did, and houses
};

// What a try at a challenge came to, or a slide in free play.
struct ResultCard {
    struct Row {
        std::string label, value;
    };
    std::string title, verdict, reason, learn;  // the last two may be empty
    std::optional<int> medal;                   // of a challenge: 0 none to 3 gold
    std::vector<Row> rows;
    std::shared_ptr<const SlideMap> map = {};  // none if nothing flowed
    glm::dvec2 top{0}, toe{0};                 // m, the ends of the slide; the same if there was none
};

// A dash around the zone of a challenge, around an area that it counts in, or around where the scene will act; or a line up a
// dam.
struct GoalLine {
    enum class Around : std::uint8_t { kZone, kCounted, kEvent, kDam, kSection };
    glm::dvec2 from{0}, to{0};  // px from the top left
    Around around = Around::kZone;
};

// What the scene of a challenge is going to do.
struct GoalEvent {
    glm::dvec2 at{0};  // px from the top left
    double in_s = 0;   // of the world
};

// What an area of a challenge has come to.
struct GoalCount {
    glm::dvec2 at{0};   // px from the top left
    double amount = 0;  // m³, or %
    bool is_share = false;
};

// What the dam near the cursor has come to.
struct DamNote {
    glm::dvec2 at{0};   // of its highest place, px from the top left
    double height = 0;  // m above the ground that was there
    double volume = 0;  // m³ of earth
};

// Where some of many runs ended.
struct RunEnd {
    glm::dvec2 at{0};      // px from the top left
    std::size_t runs = 1;  // that ended there
    bool is_open = false;  // the world in the window is that of one of them
};
// The runs that are shown, with their probabilities.
struct RunsNote {
    std::function<const char*(std::size_t)> map_name;  // what a probability is of
    std::size_t maps = 0, chosen = 0;
    std::span<const RunEnd> ends;
    struct Under {
        glm::dvec2 at{0};  // px from the top left
        std::string_view words;
    };
    std::optional<Under> under = {};         // the end under the cursor
    std::optional<double> probability = {};  // of the ground under the cursor, 0 to 1
};

// A cross-section, and where its line is on the screen.
struct SectionNote {
    const CrossSection& section;
    bool waits = false;                            // for the drag that draws its line
    std::span<const GoalLine> pieces = {};         // of the line that can be seen
    std::optional<glm::dvec2> from = {}, to = {};  // its ends, px from the top left; nothing if hidden
};

// Where the number of a house of the history stands.
struct HouseMark {
    std::size_t house = 0;  // in SlideHistory::houses()
    glm::dvec2 at{0};       // px from the top left
};

// The camera path that is made by hand.
struct PathNote {
    std::span<const CameraKey> keys;  // by time
    bool plays = false;               // its preview
    double now_s = 0;                 // of the world
};

// How a photo will be taken.
struct PhotoNote {
    PhotoSettings settings;
    FocalLengths focal;                // that the camera may have
    double hour = 12;                  // of the light, or of a light like it
    ScreenSize screen;                 // px
    std::optional<double> taken = {};  // 0 to 1, how much is drawn, while it is
    double focus_m = 0;                // how far away is what is sharp, if not all is
};

// A stop of a lesson, whose card is open.
struct LessonNote {
    const char* title;
    const Lesson::Stop& stop;
    const LessonFigures& figures;
    std::size_t number = 1, stops = 1;       // which of them it is
    std::optional<std::size_t> answer = {};  // that was given
    bool has_guess = false;                  // a place was clicked at, at this stop or before
    bool tells_guess = false;                // the last stop says how far off that was
    std::optional<double> guess_off = {};    // m
};
// A place of a lesson on the terrain.
struct LessonMark {
    glm::dvec2 at{0};      // px from the top left
    bool is_guess = true;  // else where the front stopped
};

// Where a part of the slide is on the screen.
struct SlideLabel {
    SlideParts::Part part = SlideParts::Part::kCrown;
    glm::dvec2 at{0};  // px from the top left
};

// Where north is, and how large the ground is drawn.
struct Compass {
    glm::dvec2 north{0, -1},
        east{1, 0};  // arrows on the ground as seen, 1 long across the view; down is positive
    std::optional<double> metre_px = {};  // a metre across the view; nothing if no ground is seen
};

// Everything that panels can show. References are valid for one frame.
struct Facts {
    const Scenario& scenario;  // initial state of the world; its params are the defaults
    const sim::State& state;   // state.params are the current parameters
    const TickClock& clock;
    const Brush& brush;
    const Deed& deed;       // what the tool does, or would do at a press
    bool brushing = false;  // a stroke is in progress
    bool touched = false;   // the user has changed the world
    std::optional<StrokeNote> stroke = {};
    std::optional<GoalUse> goal_use = {};  // of a challenge
    std::span<const GoalLine> goal_lines = {};
    std::span<const GoalEvent> goal_events = {};
    std::span<const GoalCount> goal_counts = {};
    std::span<const GoalLine> dam_lines = {};  // none: no tool for earth is in hand
    std::optional<DamNote> dam = {};
    const ResultCard* card = nullptr;  // none: no try and no slide has ended, or the card was closed
    std::optional<GhostNote> ghost = {};
    std::optional<RunsNote> runs = {};
    std::optional<SectionNote> section = {};  // none: its panel is closed
    const SlideHistory* history = nullptr;    // the same
    std::span<const HouseMark> houses = {};   // the same
    std::span<const SlideLabel> slide_labels = {};
    std::optional<Compass> compass = {};    // none: labels are off
    std::optional<LessonNote> lesson = {};  // none: no card of a lesson is open
    std::span<const LessonMark> lesson_marks = {};
    std::span<const BestRun> best_runs = {};  // of the challenge, the best first
    std::size_t actions_to_undo = 0, actions_to_redo = 0;
    std::optional<Reading> under_cursor;
    CameraMode camera_mode = CameraMode::kOrbit;
    const Display& display;
    const FrameTimes& times;
    const Notices& notices;
    const Catalogue& catalogue;
    Keys keys;                         // and their names
    const Gamepad* gamepad = nullptr;  // none: there is none
    Timeline timeline;
    std::span<const TimeMark> time_marks = {};  // by tick
    bool skips = false;                         // to the end of the slide
    bool in_lesson = false;                     // read-only to its end
    bool looks_back() const { return state.tick < timeline.known_until || in_lesson; }  // read-only
    bool is_bare() const {
        return game::is_bare(scenario, state) && !scenario.goal && !looks_back() && !timeline.watches;
    }
    std::string_view recording;                      // file that is being written; empty if none
    std::string_view renderer;                       // GL's name
    std::string_view sound_fault = {};               // why nothing is heard; empty if something can be
    std::span<const LanguageChoice> languages = {};  // English first
    double now_s = 0;                                // screen's clock
    ImageSize image = {};                            // of the world, as last drawn
    std::optional<double> sharing = {};              // 0 to 1, how much of the page of a shared slide is done
    std::optional<double> filming = {};              // 0 to 1, how much of a film is done
    PathNote path = {};                              // the camera path
    std::optional<PhotoNote> photo = {};             // in the photo mode, in which nothing else is shown
    bool making_challenge = false;                   // of the slide, in the background
    bool may_try = false;                  // a recording of a challenge was opened, which can be tried
    bool slide_ended = false;              // it has come to rest, and was not shared yet
    const Guide* guide = nullptr;          // none: nobody is led
    std::optional<double> opening_s = {};  // s since the slide to watch began, while it is watched
    std::optional<glm::dvec2> place_to_click = {};  // px, while the guide shows one
};

}  // namespace game::ui
