#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <glm/vec2.hpp>

#include "render/buildings/structures.h"
#include "sim/world/state.h"

namespace game {

// Limits of what a scene may have, so that its meshes stay below about 60 MB.
inline constexpr std::size_t kMostHuts = 200, kMostLifts = 8, kMostRoads = 8, kMostRoadPoints = 200;
inline constexpr double kNarrowestRoad = 2, kWidestRoad = 30;     // m
inline constexpr double kShortestLift = 60, kLongestLift = 5000;  // m

// What is wrong with the points of a road, such as "has the same place twice in a row"; or nothing.
std::optional<std::string> fault_of_road(std::span<const glm::dvec2> points);
// What is wrong with a lift between these stations, such as "is 3 m away; 60 to 5000 m are allowed"; or nothing.
std::optional<std::string> fault_of_lift(glm::dvec2 valley, glm::dvec2 mountain);
// Adds a straight chairlift between two stations, with pylons at equal distances.
void add_lift(glm::dvec2 valley, glm::dvec2 mountain, render::Structures& structures);
// Its stations.
std::pair<glm::dvec2, glm::dvec2> stations(const render::Structures& structures, const render::Lift& lift);

// What is wrong with these structures on a grid, such as "hut 3 at (1200, 50) is outside the terrain"; or nothing.
// `has_data`: one value per vertex, row 0 the south.
std::optional<std::string> fault_of(const render::Structures& structures, const sim::Grid& grid,
                                    std::span<const std::uint8_t> has_data);

// Adds the things of a world, as they are drawn: pieces of road whose ends meet are one road, what one command built of
// stations and pylons is a lift. `first_depth`: of the standing layer at tick 0, m, one value per vertex.
void add_things(const sim::View& world, std::span<const float> first_depth, render::Structures& into);

// Sets the state of structures from what a flow has done until now. A view: no flow knows of it, and none is stopped.
//
// The load is q = p min(1, h / 1 m), from the greatest impact pressure p and the greatest depth h at each place of its
// footprint; they may come from different moments, which makes q too large, never too small. A structure is damaged
// from half of its strength on and destroyed from all of it: 5 kPa for wood, 10 for a station's frame, 100 for a
// pylon, which flows pass on both sides. It is buried if the surface has risen to its top. After these structures come
// the things of the world, whose state it knows itself.
class StructureWatch {
  public:
    StructureWatch(const render::Structures& structures, const sim::View& world);

    // `pressure` (kPa) and `depth` (m): greatest until now, one value per vertex. Empty pressure: nothing breaks.
    void watch(const sim::View& world, std::span<const float> pressure, std::span<const float> depth);
    const render::Structures& structures() const { return structures_; }

  private:
    void take_states(const sim::View& world);

    render::Structures structures_;
    std::int64_t changed_ = -1;  // sim::Things::changed when structures_ were made; −1: without things
    render::Structures views_;   // of these, without the things
    std::vector<double> first_surface_;  // m, at the middle of each view
    std::vector<float> first_depth_;     // m
};

}  // namespace game
