#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <variant>
#include <vector>

#include <glm/vec2.hpp>

#include "game/controls/action.h"
#include "game/controls/events.h"
#include "game/controls/screen.h"
#include "game/controls/tools.h"

namespace game {

// What a gamepad's buttons do. Its left stick moves the cursor, and A presses the left button of the mouse, so that panels
// and menu need no rules of their own. Buttons have the names and places of an Xbox controller, as GLFW maps all others.

// A button that acts when it is pressed.
struct PadBinding {
    PadButton button;
    Verb does;
    std::string_view name, meaning;
};
std::span<const PadBinding> pad_bindings();

// What has no verb: sticks, triggers, and buttons that are held.
struct PadPart {
    std::string_view name, meaning;
};
std::span<const PadPart> pad_parts();

// The button of a verb; empty: none.
std::string_view pad_name_of(Verb verb);

// Choices in a circle, which a held button opens: the stick points at one, and letting the button go takes it.
enum class PadWheel : std::uint8_t { kTools, kTime };
struct PadChoice {
    std::variant<Verb, Tool> does;
    std::string_view label;
};
std::span<const PadChoice> choices_of(PadWheel wheel);  // clockwise from the top

// A hand on a gamepad. Turns what it reports into events of a mouse, movements of the camera, and actions.
class Gamepad {
  public:
    struct Seen {
        ScreenSize screen;
        bool flies = false;      // the camera, by the left stick
        bool in_panels = false;  // the menu is open: B goes back, and no verb of the world acts
        double elapsed_s = 0;
    };
    // Call once per frame, before the events are used: appends to both. `state`: nothing without a gamepad; what it held
    // is then let go.
    void take(const std::optional<PadState>& state, const Seen& seen, std::vector<Event>& events,
              Actions& actions);
    // A mouse or a key was used, so that nothing is named after the gamepad until it is used again.
    void yield() { in_use_ = false; }

    bool is_there() const { return before_.has_value(); }
    bool in_use() const { return in_use_; }  // used last

    // Movements of the camera in this frame. Turn: in image widths, as a drag from −1 to 1. Walk: right, forward, −1 to 1.
    glm::dvec2 turn() const { return turn_; }
    glm::dvec2 walk() const { return walk_; }

    struct Open {
        PadWheel wheel;
        std::optional<std::size_t> chosen;  // of its choices
    };
    const std::optional<Open>& wheel() const { return wheel_; }

  private:
    void point(const PadState& state, const Seen& seen, std::vector<Event>& events);
    void press(const PadState& state, const Seen& seen, std::vector<Event>& events, Actions& actions);
    void hold_wheel(const PadState& state, Actions& actions);
    void let_go(std::vector<Event>& events);

    std::optional<PadState> before_;
    std::optional<glm::dvec2> cursor_;  // px; nothing until it was moved here
    bool in_use_ = false, pressed_ = false;
    Modifiers with_;
    glm::dvec2 turn_{0}, walk_{0};
    std::optional<Open> wheel_;
};

}  // namespace game
