#pragma once

#include <span>

#include <imgui.h>

#include "game/controls/tools.h"

namespace game::ui {

// Icons of buttons, drawn as vectors so that they are sharp at any size.
enum class Icon {
    kPause,
    kPlay,
    kStep,
    kBack,
    kUndo,
    kRedo,
    kReset,
    kShare,
    kScene,
    kPhysics,
    kDisplay,
    kPerformance,
    kHelp,
    kClose,
};

// Draws an icon within a square of `size` px around `centre`.
void draw_icon(ImDrawList& list, Icon icon, ImVec2 centre, float size, ImU32 colour);
// The same of a tool, from its row.
void draw_icon(ImDrawList& list, std::span<const IconPart> parts, ImVec2 centre, float size, ImU32 colour);

}  // namespace game::ui
