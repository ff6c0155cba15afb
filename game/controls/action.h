#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include <glm/vec2.hpp>

#include "game/controls/brush.h"
#include "game/controls/display.h"
#include "game/controls/events.h"
#include "game/controls/film_wish.h"
#include "game/controls/photo.h"
#include "game/scene/scene.h"

namespace game {

// User requests, by key, mouse or panel: the interface between input and the app. Requests that change the
// world become commands.

// Requests without parameters.
enum class Verb {
    kPauseOrGoOn,
    kStepOnce,    // one tick, then pause
    kSlower,      // half the speed
    kFaster,      // twice the speed
    kUsualSpeed,  // 1
    kSlowMotion,  // toggles
    kStepBack,    // one tick back, then pause
    kRunBack,     // toggles rewinding
    kMarkBefore,  // goes to the nearest mark on the timeline
    kMarkAfter,
    kSkip,      // toggles: runs the slide to its end, or goes to the present
    kTakeOver,  // branch: continue from this tick
    kUndo,      // go back to just before the last action
    kRedo,
    kReset,  // restart the scene
    kSmallerBrush,
    kLargerBrush,
    kWeakerBrush,
    kStrongerBrush,
    kPourStandingOrRolling,
    kOverview,      // camera that shows the whole terrain
    kTopDown,       // toggles
    kFly,           // toggles
    kChase,         // toggles
    kSpeedColours,  // toggles
    kFieldWords,    // toggles
    kToggleScene,   // panels
    kTogglePhysics,
    kToggleDisplay,
    kTogglePerformance,
    kToggleFilm,
    kToggleMeasure,
    kToggleHelp,
    kClosePanel,    // the open list, else the help, else the last opened panel; else opens the menu
    kMenu,          // opens and closes it
    kTogglePanels,  // all of them, and what is in the corners
    kShare,         // page and recording of the slide in a new folder
    kPhoto,         // toggles the photo mode
    kLabels,        // toggles those of the slide
    kScreenshot,    // of the world alone; in the photo mode the photo
    kFullscreen,
    kMute,  // toggles sound
    kQuit,
};
inline constexpr std::size_t kVerbs = static_cast<std::size_t>(Verb::kQuit) + 1;

struct SetSpeed {
    double speed;  // simulated time per real time, 1/8 to 16
};
// Goes to another known tick, earlier or later.
struct SeekTick {
    std::int64_t tick;
};
struct SetBrush {
    Brush brush;
};
struct SetNumber {
    std::size_t param;  // index in sim::kParams
    float value;        // in its unit
};
struct SetDisplay {
    Display display;
};
// Opens a scene, a terrain file or a recording, recognised by its file type.
struct Open {
    std::string name_or_path;
    Overrides overrides;
    bool goes_on = false;  // a recording is played to its end at once, and continued there
};

// Turns the camera to a place in plan, m.
struct LookAt {
    glm::dvec2 place;
};
// Plays the slide that the card tells about once more, seen from where it came to rest.
struct SeeFromFront {};

// What the guide is to do: end the current hint, or start again.
struct GuideWish {
    enum Kind { kNext, kAgain } kind;
};

// Saves the world as it stands, as a scene of one's own.
struct SaveWorld {
    std::string name;  // of its file; empty: the title of the world
};
// Makes a challenge of what was done in this world.
struct MakeChallenge {};
// Shares the challenge, untouched, with the best run at it to beat.
struct ChallengeFriend {};
// Begins the challenge of the recording that was opened, from its start and untouched.
struct TryChallenge {};

// Gives an action another key: the row of the key map, and what it has then (KeyMap::bind).
struct BindKey {
    std::size_t row;
    Key key;
    Modifiers with;
};
struct ResetKeys {};

// What is done to a file that a person has made.
struct RenameFile {
    std::filesystem::path file;
    std::string name;
};
struct ThrowAway {  // into the trash
    std::filesystem::path file;
};
struct ShowFile {  // its folder, in the file manager
    std::filesystem::path file;
};

// In the photo mode.
struct SetPhoto {
    PhotoSettings settings;
};

// Films what is on the timeline, while the window goes on; and ends that.
struct FilmSlide {
    FilmWish wish;
};
struct StopFilm {};

// Of the camera path that is made by hand: a key of the camera now, or one that there is; its preview; its file.
struct EditPath {
    enum class What : std::uint8_t { kAdd, kGoTo, kRemove, kPlay, kStop, kSave, kLoad } what = What::kAdd;
    std::size_t key = 0;  // of kGoTo and kRemove
};

// At the card of a lesson: time goes on, or an answer to its question.
struct LessonWish {
    std::optional<std::size_t> answer;  // none: time goes on
};

// The next drag on the terrain is the line of the cross-section, and no stroke; or no longer.
struct DrawSection {
    bool waits;
};

// Covers ground on which nothing lies with material, and begins its world anew.
struct CoverGround {
    double depth;  // m
};

// A Tool is chosen.
using Action = std::variant<Verb, Tool, SetSpeed, SeekTick, SetBrush, SetNumber, SetDisplay, Open, LookAt,
                            SeeFromFront, GuideWish, SaveWorld, MakeChallenge, TryChallenge, ChallengeFriend,
                            CoverGround, BindKey, ResetKeys, SetPhoto, FilmSlide, StopFilm, EditPath,
                            RenameFile, ThrowAway, ShowFile, DrawSection, LessonWish>;
using Actions = std::vector<Action>;

}  // namespace game
