#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <glm/vec2.hpp>

#include "render/buildings/structures.h"
#include "sim/world/state.h"

namespace game {

// Limits of what a scene may have, so that its meshes stay below about 60 MB.
inline constexpr std::size_t kMostLifts = 8, kMostRoads = 8, kMostRoadPoints = 200;

// What is wrong with the points of a road, such as "has the same place twice in a row"; or nothing.
std::optional<std::string> fault_of_road(std::span<const glm::dvec2> points);
// What is wrong with a lift between these stations, such as "is 3 m away; 60 to 5000 m are allowed"; or nothing.
std::optional<std::string> fault_of_lift(glm::dvec2 valley, glm::dvec2 mountain);
// The things of a world, as they are drawn: pieces of road whose ends meet are one road, what one command built of
// stations and pylons is a lift. `first_depth`: of the standing layer at tick 0, m, one value per vertex.
render::Structures structures_in(const sim::View& world, std::span<const float> first_depth);

// What stands in a world and what became of it, as it is drawn. Something is buried if the layers above it are as high as
// it is.
class StructureWatch {
  public:
    explicit StructureWatch(const sim::View& world);

    void watch(const sim::View& world);
    const render::Structures& structures() const { return structures_; }

  private:
    void take_states(const sim::View& world);

    render::Structures structures_;
    std::int64_t changed_ = -1;       // sim::Things::changed when structures_ were made; −1: without things
    std::vector<float> first_depth_;  // m
};

}  // namespace game
