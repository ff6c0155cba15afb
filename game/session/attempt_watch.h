#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "game/scene/goal.h"
#include "sim/world/state.h"

namespace game {

// Finds when a try at a challenge ends: when its flow has got no farther for some seconds and has lost most of its
// energy, but not before its last event; or when its time is over. A view: a copy of it is all of its memory.
class AttemptWatch {
  public:
    static constexpr double kFlowDepth = 0.1;  // m, of a flow that reaches a place; as Measures::kExtentDepth
    static constexpr double kCalm = 5;         // s for which the flow gets no farther
    static constexpr double kCalmShare = 0.25;  // of its greatest energy since the last command

    AttemptWatch(const Goal& goal, float tick_s);

    // Call after every tick; `acted`: commands were applied at its start.
    void see(const sim::State& state, bool acted);
    std::optional<std::int64_t> ended_at() const { return ended_at_; }  // tick

  private:
    // How far the flow reached from vertex (0, 0), in cells: west, east, south, north, and between them.
    using Reach = std::array<int, 8>;
    // Returns the energy of the flow, twice that per density and area of a cell, and moves its reach.
    double see_flow(const sim::State& state);

    std::int64_t calm_ = 0, earliest_ = 0;  // ticks
    std::int64_t last_event_ = -1;          // tick
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
