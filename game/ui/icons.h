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
    kSkip,
    kBack,
    kUndo,
    kRedo,
    kReset,
    kShare,
    kScene,
    kPhysics,
    kDisplay,
    kPerformance,
    kFilm,
    kMeasure,
    kHelp,
    kClose,
    kLeft,
    kMenu,
    kLock,
};

// Draws an icon within a square of `size` px around `centre`.
void draw_icon(ImDrawList& list, Icon icon, ImVec2 centre, float size, ImU32 colour);
// The same of a tool, from its row.
void draw_icon(ImDrawList& list, std::span<const IconPart> parts, ImVec2 centre, float size, ImU32 colour);

// Three stars in a row for a medal: as many as it is worth are filled with its colour, the others are outlines.
// `left`: the middle of their left edge; `em`: px.
inline constexpr float kStarsWidth = 2.7f;  // em
void draw_stars(ImDrawList& list, int medal, ImVec2 left, float em, ImU32 outline);

}  // namespace game::ui
