#pragma once

#include <array>
#include <optional>
#include <span>

#include <glm/vec2.hpp>

#include "game/controls/action.h"
#include "game/controls/events.h"
#include "game/controls/key_map.h"
#include "game/controls/screen.h"

namespace game {

// Converts events to actions, using a key map and the gestures of key_map.h. Does not depend on the world.
class Input {
  public:
    // `map` outlives it, and may change.
    explicit Input(const KeyMap& map) : map_(&map) {}

    // The input that panels use in this frame (ui/ui.h).
    struct Kept {
        bool mouse = false;
        KeysKept keys = KeysKept::kNone;
    };
    // Processes the events of a frame and appends the requested actions to `actions`.
    void take(std::span<const Event> events, ScreenSize size, Kept kept, Actions& actions);

    // Cursor position, −1 (left, bottom) to 1; nothing over a panel or before the first event.
    std::optional<glm::dvec2> cursor() const;
    Modifiers modifiers() const { return with_; }  // held

    // The brush button: pressed in this frame; held at the end of it.
    bool brush_pressed() const { return brush_pressed_; }
    bool brush_held() const { return drag_ == Gesture::kBrush; }
    // Where the cursor was when it was released in this frame; it may have moved on since.
    std::optional<glm::dvec2> brush_released_at() const { return brush_released_at_; }

    // The camera. A drag runs from the cursor at the end of the last frame, or from where the button was
    // pressed, to the current position.
    std::optional<Gesture> camera_drag() const;  // kTurn or kPan
    bool camera_drag_began() const { return camera_pressed_; }
    glm::dvec2 drag_from() const { return from_; }
    double zoom_steps() const { return zoom_steps_; }
    double resize_steps() const { return resize_steps_; }  // of the brush, by the wheel
    // Turning that is no drag, by a touchpad or a gamepad, image coordinates.
    glm::dvec2 turn() const { return turn_; }
    // Adds what a gamepad does to the camera in this frame; after take().
    void add(glm::dvec2 turn, glm::dvec2 walk) { turn_ += turn, walk_ = walk; }
    double held(Held towards, Held away) const;  // of keys and the stick, −1 to 1
    bool fast() const { return with_.shift; }

    bool close_asked() const { return close_asked_; }
    bool focused() const { return focused_; }  // keys come here, and not to another window
    bool dropped() const { return dropped_; }

  private:
    void take_key(const KeyEvent& event, KeysKept kept, Actions& actions);
    void take_button(const ButtonEvent& event, bool kept);
    void take_wheel(const WheelEvent& event);
    void release_all();

    const KeyMap* map_;
    ScreenSize size_;
    Modifiers with_;
    std::array<bool, kKeys> down_{};
    std::optional<glm::dvec2> at_;  // cursor, in image coordinates
    bool over_panel_ = false;
    std::optional<Gesture> drag_;  // in progress, with its button
    Button drag_button_ = Button::kLeft;
    glm::dvec2 from_{0};
    // Of this frame:
    bool brush_pressed_ = false, camera_pressed_ = false, close_asked_ = false, dropped_ = false;
    bool focused_ = true;
    std::optional<glm::dvec2> brush_released_at_;
    double zoom_steps_ = 0, resize_steps_ = 0;
    glm::dvec2 turn_{0}, walk_{0};
};

}  // namespace game
