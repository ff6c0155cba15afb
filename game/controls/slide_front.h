#pragma once

#include <optional>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "sim/world/state.h"

namespace game {

// Where the fast front of a slide is, for a camera that follows it. Of several slides it stays with one until nothing
// of that moves fast. A view, which never affects the world.
class SlideFront {
  public:
    // Call once per frame. Costs one look at the cells around the front, and at all cells while there is none.
    void see(const sim::View& world);
    void forget() { front_.reset(); }

    struct Front {
        glm::dvec3 at{0};       // m, on the surface
        glm::dvec2 heading{0};  // of length 1, in plan
    };
    const std::optional<Front>& front() const { return front_; }

  private:
    std::optional<Front> front_;
};

}  // namespace game
