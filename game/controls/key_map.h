#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "game/controls/action.h"
#include "game/controls/events.h"

namespace game {

// Every key and every gesture of the sandbox, once: input acts by these tables and help is printed from them.

// A key that does something when it goes down.
struct KeyBinding {
    Key key;
    Modifiers with;  // exactly these
    bool repeats;    // goes on while the key is held
    Verb verb;
    std::string_view meaning;
};
std::span<const KeyBinding> key_bindings();

// Keys that do something as long as they are held.
enum class Held { kForward, kBack, kLeft, kRight, kUp, kDown };
struct HeldBinding {
    Key key;
    Held held;
    std::string_view meaning;
};
std::span<const HeldBinding> held_bindings();

// What the mouse does on the mountain.
enum class Gesture { kBrush, kTurn, kPan, kZoom, kResizeBrush };
struct GestureBinding {
    std::string_view hand;         // "Right drag"
    std::optional<Button> button;  // none: the wheel
    bool shift;                    // with Shift held
    Gesture gesture;
    std::string_view meaning;
};
std::span<const GestureBinding> gesture_bindings();

// "Ctrl+Z", "Space", "F1", as a person reads it on a key; empty for a key without a name. Short enough for a
// std::string that does not allocate, but for a key with all three modifiers.
std::string name_of(Key key, Modifiers with = {});
// The key of a verb; the first where it has several.
std::string name_of(Verb verb);

}  // namespace game
