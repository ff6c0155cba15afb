#pragma once

#include <array>
#include <cstddef>
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
    double sideways = 0;  // positive: to the right; of a touchpad or a tilted wheel
};
struct TextEvent {
    char32_t character;
};
struct FocusEvent {
    bool focused;  // when focus is lost, nothing is held any more
};
struct DropEvent {};  // files were dropped: Screen::dropped() has their paths
struct CloseEvent {};

// A gamepad, with the buttons and axes of an Xbox controller in GLFW's order.
enum class PadButton : std::uint8_t {
    kA,
    kB,
    kX,
    kY,
    kLeftBumper,
    kRightBumper,
    kBack,
    kStart,
    kGuide,
    kLeftStick,
    kRightStick,
    kUp,
    kRight,
    kDown,
    kLeft,
};
inline constexpr std::size_t kPadButtons = static_cast<std::size_t>(PadButton::kLeft) + 1;
enum class PadAxis : std::uint8_t { kLeftX, kLeftY, kRightX, kRightY, kLeftTrigger, kRightTrigger };
inline constexpr std::size_t kPadAxes = static_cast<std::size_t>(PadAxis::kRightTrigger) + 1;

struct PadState {
    std::array<float, kPadAxes> axes{0, 0, 0, 0, -1, -1};  // −1 to 1, y down; a trigger rests at −1
    std::array<bool, kPadButtons> buttons{};
    bool operator==(const PadState&) const = default;

    // Whether it is held: a button is down, or a stick or a trigger is far from its rest.
    bool is_used() const {
        constexpr float kFar = 0.3f;
        for (const bool down : buttons)
            if (down) return true;
        for (std::size_t i = 0; i < kPadAxes; ++i) {
            const float rest = i < static_cast<std::size_t>(PadAxis::kLeftTrigger) ? 0.f : -1.f;
            if (axes[i] - rest > kFar || rest - axes[i] > kFar) return true;
        }
        return false;
    }
};

using Event =
    std::variant<KeyEvent, ButtonEvent, MoveEvent, WheelEvent, TextEvent, FocusEvent, DropEvent, CloseEvent>;

}  // namespace game
