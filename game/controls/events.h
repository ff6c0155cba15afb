#pragma once

#include <cstdint>
#include <variant>

namespace game {

// Input events, independent of any windowing library. Positions are in framebuffer pixels from the top left,
// so they do not depend on the monitor's scale.

// Named keys; letters and digits are their ASCII capitals.
enum class Key : std::uint16_t {
    kNone = 0,
    kSpace = ' ',
    kComma = ',',
    kMinus = '-',
    kPeriod = '.',
    kEqual = '=',
    kLeftBracket = '[',
    kRightBracket = ']',
    kExtra1 = 161,  // keys that a US keyboard lacks
    kExtra2,
    kEscape = 256,
    kEnter,
    kTab,
    kBackspace,
    kDelete,
    kLeft,
    kRight,
    kUp,
    kDown,
    kHome,
    kEnd,
    kPageUp,
    kPageDown,
    kShift,  // either one, as are the two below
    kControl,
    kAlt,
    kF1 = 290,  // to kF1 + 11
};
constexpr Key key(char letter) {
    return static_cast<Key>(letter);
}
constexpr Key function_key(int number) {
    return static_cast<Key>(static_cast<int>(Key::kF1) + number - 1);
}
constexpr bool is_function_key(Key key) {
    return key >= function_key(1) && key <= function_key(12);
}
inline constexpr int kKeys = 320;  // greater than any key

enum class Button : std::uint8_t { kLeft, kRight, kMiddle };
inline constexpr int kButtons = 3;

// Modifiers held during an event. A modifier key's own press or release is already included.
struct Modifiers {
    bool shift = false, control = false, alt = false;
    bool operator==(const Modifiers&) const = default;
};

struct KeyEvent {
    Key key;
    bool down;
    bool repeat;  // automatic repeat while the key is held
    Modifiers with;
};
struct ButtonEvent {
    Button button;
    bool down;
    Modifiers with;
};
struct MoveEvent {
    double x, y;  // px
};
struct WheelEvent {
    double steps;  // positive: away from the user
    Modifiers with;
};
struct TextEvent {
    char32_t character;
};
struct FocusEvent {
    bool focused;  // when focus is lost, nothing is held any more
};
struct DropEvent {};  // files were dropped: Screen::dropped() has their paths
struct CloseEvent {};

using Event =
    std::variant<KeyEvent, ButtonEvent, MoveEvent, WheelEvent, TextEvent, FocusEvent, DropEvent, CloseEvent>;

}  // namespace game
