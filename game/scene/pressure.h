#pragma once

#include <optional>

#include "game/scene/scenario.h"

namespace game {

// Densities of the flowing materials, kg/m³.
struct Densities {
    double upper = 0, lower = 0;  // `lower` equals `upper` in a world of one material

    // Of a mixture; `lower_share` is the fraction of the lower material by volume.
    double of(double lower_share) const { return upper + lower_share * (lower - upper); }
};

// Nothing unless the density of every material of the world is known.
std::optional<Densities> densities_of(const Scenario& scenario);

// Impact pressure p = ρ v², kPa, of a flow with this speed along the slope (m/s).
inline double impact_pressure(double density, double speed_slope) {
    return density * speed_slope * speed_slope / 1000;
}

}  // namespace game
