#include "game/scene/mountains.h"

#include <fmt/format.h>

namespace game {

render::Surroundings mountains_around(const Scenario& scenario) {
    if (scenario.flow) return {};
    const std::vector<float> none;
    return {scenario.grid, scenario.bedrock, scenario.depth, scenario.has_data,
            scenario.lower ? scenario.lower->depth : none};
}

render::Woods woods_on(const Scenario& scenario, const render::Surroundings& mountains) {
    return {mountains, scenario.trees, scenario.datum};
}

std::string woods_notice(const Scenario& scenario, const render::Woods& woods) {
    if (!scenario.model && !scenario.flow && scenario.trees.density > 0 && woods.empty())
        return "The scene asks for trees, and there is no place for one. Compare tree_line, polygon and "
               "raster of "
               "[trees] with the ground";
    if (woods.asked() <= static_cast<double>(woods.trees().size())) return "";
    return fmt::format("The scene asks for {:.0f} trees, and {} are drawn. Use a smaller [trees] density",
                       woods.asked(), woods.trees().size());
}

}  // namespace game
