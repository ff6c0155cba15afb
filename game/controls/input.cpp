#include "game/controls/input.h"

#include <algorithm>

namespace game {
namespace {

std::optional<Gesture> gesture_of(std::optional<Button> button, bool shift) {
    for (const GestureBinding& binding : gesture_bindings())
        if (binding.button == button && binding.shift == shift) return binding.gesture;
    return std::nullopt;
}

bool may_act(const KeyBinding& binding, KeysKept kept) {
    const Verb* const verb = std::get_if<Verb>(&binding.does);
    switch (kept) {
        case KeysKept::kNone:
            return true;
        case KeysKept::kOfText:  // function keys type nothing
            return is_function_key(binding.key);
        case KeysKept::kOfWorld:
            return verb && (*verb == Verb::kClosePanel || *verb == Verb::kMenu || *verb >= Verb::kScreenshot);
        case KeysKept::kAll:
            return false;
    }
    return false;
}

}  // namespace

void Input::take(std::span<const Event> events, ScreenSize size, Kept kept, Actions& actions) {
    size_ = size;
    over_panel_ = kept.mouse;
    brush_pressed_ = camera_pressed_ = close_asked_ = dropped_ = false;
    zoom_steps_ = resize_steps_ = 0;
    turn_ = walk_ = {0, 0};
    brush_released_at_.reset();
    from_ = at_.value_or(glm::dvec2(0));

    for (const Event& event : events) {
        if (const auto* key = std::get_if<KeyEvent>(&event)) take_key(*key, kept.keys, actions);
        if (const auto* button = std::get_if<ButtonEvent>(&event)) take_button(*button, kept.mouse);
        if (const auto* wheel = std::get_if<WheelEvent>(&event); wheel && !kept.mouse) take_wheel(*wheel);
        if (const auto* move = std::get_if<MoveEvent>(&event); move && size.width > 0)
            at_ = glm::dvec2(2 * move->x / size.width - 1, 1 - 2 * move->y / size.height);
        if (const auto* focus = std::get_if<FocusEvent>(&event)) {
            focused_ = focus->focused;
            if (!focused_) release_all();
        }
        close_asked_ |= std::holds_alternative<CloseEvent>(event);
        dropped_ |= std::holds_alternative<DropEvent>(event);
    }
}

std::optional<glm::dvec2> Input::cursor() const {
    // A stroke continues under a panel, because the drag started on the terrain.
    return over_panel_ && !brush_held() ? std::nullopt : at_;
}

std::optional<Gesture> Input::camera_drag() const {
    return drag_ == Gesture::kTurn || drag_ == Gesture::kPan ? drag_ : std::nullopt;
}

double Input::held(Held towards, Held away) const {
    if (with_.control || with_.alt) return 0;  // with these the keys have other meanings
    bool to = false, fro = false;
    for (const HeldBinding& binding : map_->holds()) {
        const bool down = down_[static_cast<std::size_t>(binding.key)];
        to |= down && binding.held == towards;
        fro |= down && binding.held == away;
    }
    const double by_keys = (to ? 1.0 : 0.0) - (fro ? 1.0 : 0.0);
    const double by_stick = towards == Held::kRight ? walk_.x : towards == Held::kForward ? walk_.y : 0;
    return std::clamp(by_keys + by_stick, -1.0, 1.0);
}

void Input::take_key(const KeyEvent& event, KeysKept kept, Actions& actions) {
    with_ = event.with;
    const auto index = static_cast<std::size_t>(event.key);
    if (index < down_.size()) down_[index] = event.down && kept == KeysKept::kNone;
    if (!event.down) return;
    for (const KeyBinding& binding : map_->presses())
        if (binding.key == event.key && binding.with == event.with && (!event.repeat || binding.repeats) &&
            may_act(binding, kept))
            std::visit([&](auto what) { actions.emplace_back(what); }, binding.does);
}

void Input::take_button(const ButtonEvent& event, bool kept) {
    with_ = event.with;
    if (!event.down) {
        if (!drag_ || event.button != drag_button_) return;
        if (drag_ == Gesture::kBrush) brush_released_at_ = at_;
        return drag_.reset();
    }
    if (kept || drag_) return;  // one drag at a time
    drag_ = gesture_of(event.button, event.with.shift);
    // Without an entry for Shift in the table, the button acts as without Shift.
    if (!drag_) drag_ = gesture_of(event.button, false);
    drag_button_ = event.button;
    brush_pressed_ |= drag_ == Gesture::kBrush;
    camera_pressed_ |= camera_drag().has_value();
    if (at_) from_ = *at_;
}

void Input::take_wheel(const WheelEvent& event) {
    const bool resize = brush_held() || gesture_of(std::nullopt, event.with.shift) == Gesture::kResizeBrush;
    constexpr double kTurn = 0.06;  // halves of an image width per step
    (resize ? resize_steps_ : zoom_steps_) += event.steps;
    if (!brush_held()) turn_.x += event.sideways * kTurn;
}

void Input::release_all() {
    down_.fill(false);
    with_ = {};
    drag_.reset();
}

}  // namespace game
