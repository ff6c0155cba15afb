#include "game/analysis/thing_results.h"

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "game/scene/surface.h"

namespace game {
namespace {

// Depth of the layers at a place above the first surface, m, between the vertices around it.
double risen(const sim::State& world, glm::dvec2 at) {
    const Square square = square_under(world.grid, at);
    return between(square, world.depth) - between(square, world.first_depth) + between(square, world.rolling);
}

glm::dvec2 from(const sim::Thing& line) {
    return {line.x, line.y};
}
glm::dvec2 to(const sim::Thing& line) {
    return {line.to_x, line.to_y};
}

}  // namespace

double length_of(const sim::Thing& line) {
    return glm::distance(from(line), to(line));
}

double blocked_of(const sim::State& world, const sim::Thing& road) {
    const double length = length_of(road);
    const int samples =
        std::max(1, static_cast<int>(std::ceil(length / (0.25 * static_cast<double>(world.grid.dx)))));
    double blocked = 0;
    for (int i = 0; i < samples; ++i)
        if (risen(world, glm::mix(from(road), to(road), (i + 0.5) / samples)) > ThingResults::kBlocking)
            blocked += length / samples;
    return blocked;
}

ThingResults thing_results(const Session& session) {
    const sim::State& world = session.state();
    const sim::Things& things = *world.things;
    const auto cell = static_cast<double>(world.grid.dx);
    constexpr double kSquareMetresPerHectare = 1e4;
    ThingResults results;
    for (int y = 0; y < world.grid.ny; ++y)
        for (int x = 0; x < world.grid.nx; ++x) {
            const sim::Stems& stems = things.forest(x, y);
            const int all = stems.standing + stems.lying;
            if (all == 0) continue;
            const double area = cell * cell / kSquareMetresPerHectare;
            results.forest_intact_ha += area * stems.standing / all;
            results.forest_broken_ha += area * stems.lying / all;
        }
    results.earth_used = session.cubic_metres(sim::earth_used(things));
    for (const sim::Thing& thing : things.list)
        if (thing.kind == sim::ThingKind::kRoad) {
            results.road += length_of(thing);
            results.road_blocked += blocked_of(world, thing);
        }
    return results;
}

}  // namespace game
