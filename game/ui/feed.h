#pragma once

#include <array>
#include <bitset>
#include <cfloat>
#include <span>
#include <vector>

#include <imgui.h>

#include "game/controls/events.h"

namespace game::ui {

// Passes events to ImGui, which sees one state of mouse and keys per frame. Events that would be lost (a
// press and release, or a press and move, in one frame) wait for the next frame, in order.
//
// A comma that is typed into a number is a point, as the decimal key of many keypads types it.
class Feed {
  public:
    Feed();  // into the current ImGui context

    void add(std::span<const Event> events);
    // Whether what is typed is a name, which may have commas, and no number.
    void type_names(bool on) { types_names_ = on; }

  private:
    bool take(const Event& event);  // false: it must wait for the next frame
    bool take(const KeyEvent& event);
    bool take(const ButtonEvent& event);
    bool take(const MoveEvent& event);
    bool take(const WheelEvent& event);
    bool take(const TextEvent& event);
    bool take(const FocusEvent& event);
    bool take(const DropEvent&) { return true; }
    bool take(const CloseEvent&) { return true; }

    std::vector<Event> waiting_;
    bool types_names_ = false;
    ImVec2 mouse_{-FLT_MAX, -FLT_MAX};  // last position, px
    // Of this frame:
    std::bitset<kKeys> keys_turned_;
    std::bitset<kButtons> buttons_turned_;
    bool key_went_down_ = false, text_came_ = false;
};

}  // namespace game::ui
