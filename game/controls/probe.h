#pragma once

#include <array>
#include <optional>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "sim/world/state.h"
#include "terrains/georeference.h"
#include "terrains/locator.h"

namespace game {

// What a person asks of a place on the surface.
struct Reading {
    glm::dvec3 at{0};      // m; z above the terrain's zero
    double slope_deg = 0;  // of the surface
    // Whither it falls: 0 north, 90 east, below 360; nothing where it is level, gentler than 1 in 1000.
    std::optional<double> aspect_deg;
    double standing = 0, rolling = 0;  // m
    double speed = 0;  // m/s, of the rolling layer; 0 where it is thinner than Peaks::kVisible
    // Share of the lower material at the nearest vertex, 0 to 1, in what rolls, else at the surface of what
    // lies; nothing in a world of one material.
    std::optional<double> lower_share;
    std::array<char, 96>
        where{};  // "47.30012° N 11.43210° E, UTM 32T 683912 5240010"; empty where not placed
};

// Reads the world at places, one after the other, without allocating.
class Probe {
  public:
    explicit Probe(const terrains::Georeference& georeference) : locator_(georeference) {}

    // Bilinear between the four vertices around; nothing beside the grid or where one of the four has no
    // data. A place a millionth of a cell beside the grid counts as on its border.
    std::optional<Reading> read(const sim::View& world, glm::dvec2 at);

  private:
    terrains::Locator locator_;
    std::optional<glm::dvec2> last_;  // the place that where_ is of
    std::array<char, 96> where_{};
};

}  // namespace game
