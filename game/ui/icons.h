#pragma once

#include <imgui.h>

namespace game::ui {

// Pictures on buttons, drawn from lines so that they are sharp at any size.
enum class Icon {
    kPour,
    kDig,
    kBlast,
    kSettle,
    kPause,
    kPlay,
    kStep,
    kBack,
    kUndo,
    kReset,
    kScene,
    kPhysics,
    kDisplay,
    kPerformance,
    kHelp,
    kClose,
};

// Within a square of `size` px around `centre`.
void draw_icon(ImDrawList& list, Icon icon, ImVec2 centre, float size, ImU32 colour);

}  // namespace game::ui
