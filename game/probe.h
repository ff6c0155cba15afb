#pragma once

#include <array>
#include <optional>

#include <glm/vec3.hpp>

#include "sim/state.h"
#include "terrains/georeference.h"
#include "terrains/locator.h"

namespace game {

// What a person asks of a place on the surface.
struct Reading {
    glm::dvec3 at;         // m; z above the terrain's zero
    double slope_deg = 0;  // of the surface
    // Whither it falls: 0 north, 90 east; nothing where it is level.
    std::optional<double> aspect_deg;
    double standing = 0, rolling = 0;  // m
    double speed = 0;                  // m/s, of the rolling layer
    std::array<char, 96> where{};      // "47.30012° N 11.43210° E, UTM 32T 683912 5240010"; empty where not placed
};

// Reads the world at places, one after the other, without allocating.
class Probe {
  public:
    explicit Probe(const terrains::Georeference& georeference);

    // Bilinear between the vertices around; nothing beside the grid or where there is no data.
    std::optional<Reading> read(const sim::View& world, glm::dvec2 at);

  private:
    terrains::Locator locator_;
};

}  // namespace game
