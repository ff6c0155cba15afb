#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include <glm/vec2.hpp>

#include "game/scene/goal.h"
#include "sim/world/state.h"

namespace game {

// Finds when a try at a challenge ends: when its flow has got no farther for some seconds and has lost most of its
// energy, but not before its last event; or when its time is over. Looks once at what the last slab that the scene lets go
// still has just before. A view: a copy of it is all of its memory.
class AttemptWatch {
  public:
    static constexpr double kFlowDepth = 0.1;  // m, of a flow that reaches a place; as Measures::kExtentDepth
    static constexpr double kCalm = 5;         // s for which the flow gets no farther
    static constexpr double kCalmShare = 0.25;  // of its greatest energy since the last command

    // The standing layer under the last blast of the scene, and the houses, at the start of the blast's tick.
    struct Slab {
        double left = 0;        // share of the volume of tick 0
        glm::dvec2 aside{0};    // from the middle of its disc to that of what is left, in radii
        std::int64_t load = 0;  // Pa, the greatest on a house so far
    };

    AttemptWatch(const Goal& goal, const sim::State& start);

    // Call after every tick; `acted`: commands were applied at its start.
    void see(const sim::State& state, bool acted);
    std::optional<std::int64_t> ended_at() const { return ended_at_; }  // tick
    // Nothing before that blast, nor if the scene has none after tick 0 where anything lies.
    const std::optional<Slab>& slab() const { return slab_; }

  private:
    struct Mass {
        double depth = 0;      // m, summed over vertices
        glm::dvec2 moment{0};  // of it about the middle of the disc, in radii
    };
    Mass mass_under_blast(const sim::State& state) const;
    // How far the flow reached from vertex (0, 0), in cells: west, east, south, north, and between them.
    using Reach = std::array<int, 8>;
    // Returns the energy of the flow, twice that per density and area of a cell, and moves its reach.
    double see_flow(const sim::State& state);

    std::int64_t calm_ = 0, earliest_ = 0;  // ticks
    std::int64_t last_event_ = -1;          // tick
    std::optional<TimedCommand> blast_;     // the scene's last one
    Mass first_;                            // under it, at tick 0
    std::optional<Slab> slab_;
    std::optional<std::int64_t> latest_;    // ticks
    std::optional<std::int64_t> begun_at_;  // tick of the first command
    std::int64_t acted_at_ = 0;             // tick of the last one
    // Since the last command:
    Reach reach_{};
    std::int64_t farther_at_ = 0;  // tick at which the flow got farther
    double greatest_energy_ = 0;
    std::optional<std::int64_t> ended_at_;
};

}  // namespace game
