#pragma once

#include "game/scene/scenario.h"
#include "render/surroundings.h"

namespace game {

// The mountains around a scenario's ground; none (empty) around a flow scene.
render::Surroundings mountains_around(const Scenario& scenario);

}  // namespace game
