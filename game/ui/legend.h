#pragma once

#include <imgui.h>

#include "render/marks.h"

namespace game::ui {

ImU32 packed(const glm::vec3& colour);  // sRGB, 0 to 1

// What the colours of an overlay mean: a bar with numbers below it, as wide as the row. Nothing where there
// are no stops.
void draw_legend(const render::Legend& legend, float em, ImFont& letters);

}  // namespace game::ui
