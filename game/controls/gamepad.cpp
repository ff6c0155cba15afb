#include "game/controls/gamepad.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>

namespace game {
namespace {

constexpr double kDead = 0.18;        // of a stick's way, in which a worn one rests
constexpr double kPull = 0.5;         // of a trigger's way, from which it counts as pressed
constexpr double kCursorSpeed = 0.9;  // image heights per second
constexpr double kTurnSpeed = 1.2;    // halves of an image width per second: 108°
constexpr double kZoomSpeed = 7;      // steps of a wheel per second
constexpr double kResizeSpeed = 7;    // the same, of the brush
constexpr double kPointsFrom = 0.5;   // of a stick's way, from which it points at a choice

constexpr std::array kBindings{
    PadBinding{PadButton::kX, Verb::kPauseOrGoOn, "X", "pause or resume"},
    PadBinding{PadButton::kB, Verb::kRunBack, "B", "rewind, or run forward again; in the menu: back"},
    PadBinding{PadButton::kY, Verb::kChase, "Y", "follow the front of a slide"},
    PadBinding{PadButton::kBack, Verb::kUndo, "Back", "undo the last action"},
    PadBinding{PadButton::kStart, Verb::kMenu, "Start", "menu"},
    PadBinding{PadButton::kLeftStick, Verb::kOverview, "Left stick pressed", "show the whole terrain"},
    PadBinding{PadButton::kRightStick, Verb::kFly, "Right stick pressed", "fly mode on or off"},
};

constexpr std::array kParts{
    PadPart{"Left stick", "move the cursor; in fly mode, move"},
    PadPart{"Right stick", "turn the view; in fly mode, look"},
    PadPart{"A", "use the tool; press a button"},
    PadPart{"Right trigger", "the same as A"},
    PadPart{"Left trigger, held", "the tool does the opposite"},
    PadPart{"Left bumper, held", "wheel of tools"},
    PadPart{"Right bumper, held", "wheel of time"},
    PadPart{"D-pad up, down", "zoom; scroll in the menu"},
    PadPart{"D-pad left, right", "smaller or larger brush"},
};

constexpr std::array kTimeChoices{
    PadChoice{Verb::kUsualSpeed, "Normal speed"}, PadChoice{Verb::kFaster, "Faster"},
    PadChoice{Verb::kStepOnce, "One tick"},       PadChoice{Verb::kTakeOver, "Continue from here"},
    PadChoice{Verb::kReset, "Restart"},           PadChoice{Verb::kRedo, "Redo"},
    PadChoice{Verb::kStepBack, "One tick back"},  PadChoice{Verb::kSlower, "Slower"},
};

bool is_down(const PadState& state, PadButton button) {
    return state.buttons[static_cast<std::size_t>(button)];
}

double axis(const PadState& state, PadAxis axis) {
    return std::clamp(static_cast<double>(state.axes[static_cast<std::size_t>(axis)]), -1.0, 1.0);
}

// A stick's direction, y up; finer near the middle.
glm::dvec2 stick(const PadState& state, PadAxis x, PadAxis y) {
    const glm::dvec2 way(axis(state, x), -axis(state, y));
    const double length = glm::length(way);
    if (!(length > kDead)) return {0, 0};
    const double strength = std::min((length - kDead) / (1 - kDead), 1.0);
    return way / length * strength * strength;
}

bool is_pulled(const PadState& state, PadAxis trigger) {
    return (axis(state, trigger) + 1) / 2 > kPull;
}

}  // namespace

std::span<const PadBinding> pad_bindings() {
    return kBindings;
}

std::span<const PadPart> pad_parts() {
    return kParts;
}

std::string_view pad_name_of(Verb verb) {
    const auto found = std::ranges::find(kBindings, verb, &PadBinding::does);
    return found == kBindings.end() ? std::string_view() : found->name;
}

std::span<const PadChoice> choices_of(PadWheel wheel) {
    static const auto tools = [] {
        std::array<PadChoice, kTools> choices{};
        for (const ToolInfo& info : tool_infos())
            choices.at(static_cast<std::size_t>(info.tool)) = {info.tool, info.plain->label};
        return choices;
    }();
    if (wheel == PadWheel::kTools) return tools;
    return kTimeChoices;
}

void Gamepad::take(const std::optional<PadState>& state, const Seen& seen, std::vector<Event>& events,
                   Actions& actions) {
    turn_ = walk_ = {0, 0};
    if (!state) {
        let_go(events);
        before_.reset();
        return;
    }
    if (!before_) before_.emplace();
    if (*state != *before_ && state->is_used()) in_use_ = true;
    if (seen.screen.width > 0) {
        point(*state, seen, events);
        press(*state, seen, events, actions);
        hold_wheel(*state, actions);
    }
    before_ = *state;
}

// Cursor, camera and wheel.
void Gamepad::point(const PadState& state, const Seen& seen, std::vector<Event>& events) {
    const glm::dvec2 left = stick(state, PadAxis::kLeftX, PadAxis::kLeftY),
                     right = stick(state, PadAxis::kRightX, PadAxis::kRightY);
    const glm::dvec2 size(seen.screen.width, seen.screen.height);
    if (!wheel_ && !seen.in_panels) turn_ = right * kTurnSpeed * seen.elapsed_s;
    const bool walks = seen.flies && !seen.in_panels;
    if (walks && !wheel_) walk_ = left;
    if (!cursor_ && in_use_) cursor_ = size / 2.0;
    if (cursor_ && !walks && !wheel_ && left != glm::dvec2(0, 0)) {
        *cursor_ += glm::dvec2(left.x, -left.y) * kCursorSpeed * size.y * seen.elapsed_s;
        cursor_ = glm::clamp(*cursor_, glm::dvec2(0, 0), size - 1.0);
        events.emplace_back(MoveEvent{cursor_->x, cursor_->y});
    }
    const auto both = [&](PadButton more, PadButton less) {
        return (is_down(state, more) ? 1.0 : 0.0) - (is_down(state, less) ? 1.0 : 0.0);
    };
    const double zoom = both(PadButton::kUp, PadButton::kDown),
                 resize = both(PadButton::kRight, PadButton::kLeft);
    if (zoom != 0) events.emplace_back(WheelEvent{zoom * kZoomSpeed * seen.elapsed_s, {}});
    if (resize != 0 && !seen.in_panels)
        events.emplace_back(WheelEvent{resize * kResizeSpeed * seen.elapsed_s, {.shift = true}});
}

void Gamepad::press(const PadState& state, const Seen& seen, std::vector<Event>& events, Actions& actions) {
    const bool press = is_down(state, PadButton::kA) || is_pulled(state, PadAxis::kRightTrigger);
    if (press != pressed_) {
        // What it began with, it ends with.
        if (press) with_ = {.control = is_pulled(state, PadAxis::kLeftTrigger)};
        if (press && cursor_) events.emplace_back(MoveEvent{cursor_->x, cursor_->y});
        events.emplace_back(ButtonEvent{Button::kLeft, press, with_});
        pressed_ = press;
    }
    for (const PadBinding& binding : kBindings) {
        if (!is_down(state, binding.button) || is_down(*before_, binding.button)) continue;
        if (!seen.in_panels || binding.does == Verb::kMenu)
            actions.emplace_back(binding.does);
        else if (binding.button == PadButton::kB)
            actions.emplace_back(Verb::kClosePanel);
    }
}

// Either stick points at a choice.
void Gamepad::hold_wheel(const PadState& state, Actions& actions) {
    const bool tools = is_down(state, PadButton::kLeftBumper), time = is_down(state, PadButton::kRightBumper);
    if (!wheel_ && tools && !is_down(*before_, PadButton::kLeftBumper)) wheel_ = Open{PadWheel::kTools, {}};
    if (!wheel_ && time && !is_down(*before_, PadButton::kRightBumper)) wheel_ = Open{PadWheel::kTime, {}};
    if (!wheel_) return;
    const auto choices = choices_of(wheel_->wheel);
    for (const auto& [x, y] :
         {std::pair(PadAxis::kLeftX, PadAxis::kLeftY), {PadAxis::kRightX, PadAxis::kRightY}}) {
        const glm::dvec2 way(axis(state, x), -axis(state, y));
        if (glm::length(way) < kPointsFrom) continue;
        const double turns = std::atan2(way.x, way.y) / (2 * std::numbers::pi);  // clockwise from the top
        const auto count = static_cast<double>(choices.size());
        wheel_->chosen = static_cast<std::size_t>(std::lround((turns + 1) * count)) % choices.size();
    }
    if (wheel_->wheel == PadWheel::kTools ? tools : time) return;
    if (wheel_->chosen)
        std::visit([&](auto what) { actions.emplace_back(what); }, choices[*wheel_->chosen].does);
    wheel_.reset();
}

void Gamepad::let_go(std::vector<Event>& events) {
    if (pressed_) events.emplace_back(ButtonEvent{Button::kLeft, false, with_});
    pressed_ = in_use_ = false;
    wheel_.reset();
    cursor_.reset();
}

}  // namespace game
