#include "game/scene/pressure.h"

namespace game {

std::optional<Densities> densities_of(const Scenario& scenario) {
    if (!scenario.density) return std::nullopt;
    if (!scenario.lower) return Densities{*scenario.density, *scenario.density};
    if (!scenario.lower->density) return std::nullopt;
    return Densities{*scenario.density, *scenario.lower->density};
}

}  // namespace game
