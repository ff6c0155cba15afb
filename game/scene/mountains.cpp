#include "game/scene/mountains.h"

namespace game {

render::Surroundings mountains_around(const Scenario& scenario) {
    if (scenario.flow) return {};
    return {scenario.grid, scenario.bedrock, scenario.depth, scenario.has_data};
}

}  // namespace game
