#pragma once

#include <string>

#include "game/recording/format.h"
#include "game/scene/scenario.h"
#include "game/session/session.h"

namespace game {

// What became of the things of a world.
struct ThingResults {
    static constexpr double kBlocking = 0.3;  // m of depth above that of tick 0, which blocks a road

    double forest_intact_ha = 0, forest_broken_ha = 0;  // by the share of stems that stand
    double earth_used = 0;                              // m³
    double road = 0, road_blocked = 0;                  // m, sampled every quarter of a cell
};
// The world of `session` must have things.
ThingResults thing_results(const Session& session);

// As part of a summary: every object with its place, strength, load, burial and state, and the results.
Json things_to_json(const Scenario& scenario, const Session& session);
// Some lines: buildings and pylons that are not intact, or all if there are few; nets and roads together.
std::string things_to_text(const Scenario& scenario, const Session& session);

}  // namespace game
