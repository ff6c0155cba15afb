#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "game/controls/action.h"
#include "game/controls/events.h"
#include "game/controls/keyboard.h"

namespace game {

// Tables of all keys and gestures. Input handling, the help panel and the page on which keys are changed use them.

// A key with exactly these modifiers; Key::kNone: none.
struct Chord {
    Key key = Key::kNone;
    Modifiers with = {};
    bool operator==(const Chord&) const = default;
};

// A key that acts when it is pressed.
struct KeyBinding {
    Key key;
    Modifiers with;  // exactly these
    bool repeats;    // repeats while the key is held
    std::variant<Verb, Tool> does;
    std::string_view name;  // in the file of settings
    std::string_view meaning;
};

// Keys that act while they are held.
enum class Held { kForward, kBack, kLeft, kRight, kUp, kDown };
struct HeldBinding {
    Key key;
    Held held;
    std::string_view name;
    std::string_view meaning;
};

// Which key does what. A person may change it; no key does two things.
class KeyMap {
  public:
    KeyMap();  // the usual keys
    static const KeyMap& usual();

    std::span<const KeyBinding> presses() const { return presses_; }  // those of tools first
    std::span<const HeldBinding> holds() const { return holds_; }

    // All rows: presses, then holds.
    std::size_t size() const { return presses_.size() + holds_.size(); }
    Chord at(std::size_t row) const;
    std::string_view name(std::size_t row) const;
    std::string_view meaning(std::size_t row) const;
    // Whether a person may change it: Escape always leads out.
    bool may_change(std::size_t row) const;
    // Whether this row can have such a chord: not a bare modifier, and of a held key no modifier.
    bool accepts(std::size_t row, Chord chord) const;
    // The other row that this chord would act for as well.
    std::optional<std::size_t> conflict(std::size_t row, Chord chord) const;

    // Gives a row a chord that it accepts. A row that had it before gets none.
    void bind(std::size_t row, Chord chord);
    bool operator==(const KeyMap& other) const;

  private:
    std::vector<KeyBinding> presses_;
    std::vector<HeldBinding> holds_;
};

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

// Which keys panels use themselves.
enum class KeysKept : std::uint8_t {
    kNone,
    kOfText,   // a number is being typed: all but function keys
    kOfWorld,  // the menu stands over the world: all but those of the program as a whole
    kAll,      // the next one will be given to an action
};

// The label of a key on a keyboard: "Ctrl+Z", "Space", "F1"; empty for a key without a name. Short enough that
// std::string does not allocate, except with all three modifiers.
std::string name_of(const KeyboardLayout& layout, Key key, Modifiers with = {});
// The same of no certain keyboard, as files have it.
std::string text_of(Chord chord);
// The chord that has this text; empty: none. Nothing if no key is called so.
std::optional<Chord> chord_of(std::string_view text);

// The keyboard in use, and what its keys do.
struct Keys {
    const KeyboardLayout& layout;
    const KeyMap& map;
    bool by_pad = false;  // a gamepad is in use: verbs are named after its buttons, if they have one
};
// The label of the key of a verb or a tool, of the first one if there are several; empty: none.
std::string name_of(const Keys& keys, Verb verb);
std::string name_of(const Keys& keys, Tool tool);
// The keys that move the camera: "W A S D".
std::string names_of_walking(const Keys& keys);

}  // namespace game
