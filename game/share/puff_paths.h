#pragma once

#include <cstdint>
#include <span>
#include <unordered_map>
#include <vector>

#include <glm/vec3.hpp>

#include "game/share/packed_stream.h"
#include "sim/powder/cloud.h"

namespace game {

// The ways of all puffs of a slide's powder: where each is at its birth, at half of its life and at its end. A page
// draws the parabola through these places.
class PuffPaths {
  public:
    // Adds the cloud as it is at a tick. Call it at equal intervals, a few ticks long.
    void see(std::span<const sim::powder::Puff> cloud, std::int64_t tick, double tick_s);
    // Writes them, in order of birth. Afterwards there are none.
    void pack(PackedStream& into);

  private:
    struct Path {
        sim::powder::Puff puff;  // as last seen
        double born;             // tick
        glm::vec3 first, middle;
    };

    std::vector<Path> paths_;
    std::unordered_map<std::uint32_t, std::size_t> in_air_;  // by seed
};

}  // namespace game
