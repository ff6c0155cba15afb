#pragma once

#include <string>

#include "game/scene/scenario.h"
#include "render/mountain/surroundings.h"
#include "render/woods/woods.h"

namespace game {

// The mountains around a scenario's ground; none (empty) around a flow scene.
render::Surroundings mountains_around(const Scenario& scenario);

// The trees on a scenario's ground and on the mountains around it. If they act, the forest of the world's state says which
// of those on the grid stand; it begins with render::forest_of() them.
render::Woods woods_on(const Scenario& scenario, const render::Surroundings& mountains);
// A notice if there are fewer than the scenario asks for, or no place for any; else empty.
std::string woods_notice(const Scenario& scenario, const render::Woods& woods);

// Both. To find them takes up to half a second.
struct Backdrop {
    render::Surroundings mountains;
    render::Woods woods;
};
Backdrop backdrop_of(const Scenario& scenario);

}  // namespace game
