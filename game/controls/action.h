#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "game/controls/brush.h"
#include "game/controls/display.h"
#include "game/scene/scene.h"

namespace game {

// What a person asks for, whether by key, mouse or panel: the seam between hands and the app. Whatever of it
// changes the world goes on as a command.

// What needs no more words.
enum class Verb {
    kPauseOrGoOn,
    kStepOnce,    // one tick, and stay paused
    kSlower,      // half the speed
    kFaster,      // twice the speed
    kUsualSpeed,  // 1
    kStepBack,    // one tick earlier, and stay paused
    kRunBack,     // time runs back, and forth again
    kTakeOver,    // hands on again, from this tick
    kUndo,        // rewinds to just before the last action
    kReset,       // begins the scene anew
    kPour,
    kDig,
    kBlast,
    kSmallerBrush,
    kLargerBrush,
    kWeakerBrush,
    kStrongerBrush,
    kPourStandingOrRolling,
    kOverview,     // the camera that shows everything
    kTopDown,      // to and fro
    kFly,          // to and fro
    kToggleScene,  // panels
    kTogglePhysics,
    kToggleDisplay,
    kTogglePerformance,
    kToggleHelp,
    kClosePanel,    // the open list, else the help, else the panel opened last
    kTogglePanels,  // all of them, and what stands in the corners
    kFullscreen,
    kQuit,
};
inline constexpr std::size_t kVerbs = static_cast<std::size_t>(Verb::kQuit) + 1;

struct SetSpeed {
    double speed;  // of simulated against real time, 1/8 to 16
};
// To another tick that is known, earlier or later.
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
// Begins anew with a scene, a terrain file or a recording, recognised by what the file is.
struct Open {
    std::string name_or_path;
    Overrides overrides;
};

using Action = std::variant<Verb, SetSpeed, SeekTick, SetBrush, SetNumber, SetDisplay, Open>;
using Actions = std::vector<Action>;

}  // namespace game
