#pragma once

#include <glm/vec2.hpp>

#include "render/view/camera.h"
#include "sim/world/state.h"

namespace game {

// A pose just beyond where a slide came to rest, low above the ground, that looks up the way it came. `top`, `toe`: the ends
// of the slide, m in plan.
render::Camera view_from_front(const sim::View& world, glm::dvec2 top, glm::dvec2 toe);

}  // namespace game
