#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>

#include "game/controls/action.h"
#include "game/controls/events.h"
#include "game/controls/keyboard.h"

namespace game {

// Tables of all keys and gestures. Input handling and the help panel both use them.

// A key that acts when it is pressed.
struct KeyBinding {
    Key key;
    Modifiers with;  // exactly these
    bool repeats;    // repeats while the key is held
    std::variant<Verb, Tool> does;
    std::string_view meaning;
};
std::span<const KeyBinding> key_bindings();  // those of tools first

// Keys that act while they are held.
enum class Held { kForward, kBack, kLeft, kRight, kUp, kDown };
struct HeldBinding {
    Key key;
    Held held;
    std::string_view meaning;
};
std::span<const HeldBinding> held_bindings();

// Mouse actions on the terrain.
enum class Gesture { kBrush, kTurn, kPan, kZoom, kResizeBrush };
struct GestureBinding {
    std::string_view hand;         // "Right drag"
    std::optional<Button> button;  // none: the wheel
    bool shift;                    // with Shift held
    Gesture gesture;
    std::string_view meaning;
};
std::span<const GestureBinding> gesture_bindings();

// The label of a key on a keyboard: "Ctrl+Z", "Space", "F1"; empty for a key without a name. Short enough that
// std::string does not allocate, except with all three modifiers.
std::string name_of(const KeyboardLayout& layout, Key key, Modifiers with = {});
// The key of a verb; the first if there are several.
std::string name_of(const KeyboardLayout& layout, Verb verb);
// The keys that move the camera: "W A S D".
std::string names_of_walking(const KeyboardLayout& layout);

}  // namespace game
