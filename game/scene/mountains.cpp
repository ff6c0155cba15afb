#include "game/scene/mountains.h"

namespace game {

render::Surroundings mountains_around(const Scenario& scenario) {
    if (scenario.flow) return {};
    const std::vector<float> none;
    return {scenario.grid, scenario.bedrock, scenario.depth, scenario.has_data,
            scenario.lower ? scenario.lower->depth : none};
}

}  // namespace game
