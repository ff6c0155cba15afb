#pragma once

#include <string>

#include "game/scene/scenario.h"
#include "render/mountain/land.h"
#include "render/mountain/surroundings.h"
#include "render/woods/woods.h"

namespace game {

// The mountains around a scenario's ground; none (empty) around a flow scene.
render::Surroundings mountains_around(const Scenario& scenario);

// What plants and water find on a scenario's ground; none (empty) without a date.
render::Land land_on(const Scenario& scenario, const render::Surroundings& mountains,
                     int most_along = render::Land::kUsual);

// The trees on a scenario's ground and on the mountains around it. If they act, the forest of the world's state says which
// of those on the grid stand; it begins with render::forest_of() them, which is the same
// with and without the land.
render::Woods woods_on(const Scenario& scenario, const render::Surroundings& mountains,
                       const render::Land& land = {});
// A notice if there are fewer than the scenario asks for, or no place for any; else empty.
std::string woods_notice(const Scenario& scenario, const render::Woods& woods);

// All three. To find them takes up to a second.
struct Backdrop {
    render::Surroundings mountains;
    render::Land land;
    render::Woods woods;
};
Backdrop backdrop_of(const Scenario& scenario);

}  // namespace game
