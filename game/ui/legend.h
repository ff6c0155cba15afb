#pragma once

#include <span>

#include <imgui.h>
#include <glm/vec3.hpp>

#include "render/marks.h"

namespace game::ui {

// A value and its colour, sRGB.
struct LegendStop {
    float value;
    glm::vec3 colour;
};

// What the colours of an overlay mean.
struct Legend {
    std::span<const LegendStop> stops;  // rising; below the first the ground shows as it is
    const char* unit;
    bool stepped;  // a stop's colour holds up to the next; else they run into each other
};
// No stops for kNone.
Legend legend_of(render::Overlay overlay);

// As a bar with numbers below it, as wide as the row.
void draw_legend(const Legend& legend, float em, ImFont& letters);

ImU32 packed(const glm::vec3& colour);

}  // namespace game::ui
