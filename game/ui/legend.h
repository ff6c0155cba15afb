#pragma once

#include <imgui.h>

#include "render/frame/marks.h"

namespace game::ui {

ImU32 packed(const glm::vec3& colour);  // sRGB, 0 to 1

// Draws the legend of an overlay: a colour bar as wide as the row, with numbers below. Draws nothing without
// stops.
void draw_legend(const render::Legend& legend, float em, ImFont& letters);

}  // namespace game::ui
