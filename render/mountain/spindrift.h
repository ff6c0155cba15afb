#pragma once

#include <span>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "render/mountain/surroundings.h"
#include "render/view/look.h"
#include "render/view/wind.h"

namespace render {

// A place on a sharp ridge whose lee lets go of snow in wind. Space as in shaders.
struct SpindriftPlace {
    glm::vec3 at;      // m, on the ridge at tick 0
    float strength;    // 0 to 1: how sharp and high the ridge is, and how much snow lies before it
    float chance;      // 0 to 1, its own number, by which places differ
    float sunlit = 1;  // share of the light that ground lets through to the snow over it, 0 to 1
};

// Whether wind lifts the snow of a look: it is bright, and much of it is thrown up as powder.
bool is_dry_snow(const Look& look);

// The ridges of a world that smoke in wind: on its grid and on the mountains near it. A view: nothing else knows
// of them. Equal on one machine, as Surroundings are.
class Ridges {
  public:
    static constexpr std::size_t kMost = 320;     // places; of more, the strongest are kept
    static constexpr double kLeastSpeed = 3;      // m/s: a weaker wind lifts no snow
    static constexpr double kGreatestSpeed = 12;  // m/s, from which on it lifts no more

    // None.
    Ridges() = default;
    Ridges(const Surroundings& around, const Wind& wind);

    std::span<const SpindriftPlace> places() const { return places_; }
    // Lights them from `sun` (unit vector, z > 0).
    void light(const Surroundings& around, const glm::vec3& sun);

  private:
    std::vector<SpindriftPlace> places_;
};

}  // namespace render
