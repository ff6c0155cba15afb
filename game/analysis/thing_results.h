#pragma once

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

// m, of an object that is a line.
double length_of(const sim::Thing& line);
// m of a piece of road, sampled every quarter of a cell.
double blocked_of(const sim::State& world, const sim::Thing& road);

}  // namespace game
