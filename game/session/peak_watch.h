#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "game/scene/pressure.h"
#include "sim/world/state.h"

namespace game {

// Per-vertex maxima since tick 0, and when the flow came, grid.size() values each. A view: never affects the world. A score is made of them, so
// they are the same on every processor and with every mathematics library.
struct Peaks {
    std::vector<float> depth;        // m, of the rolling layer
    std::vector<float> speed_plan;   // m/s, where that layer was at least kVisible deep
    std::vector<float> speed_slope;  // m/s, the same along the slope of the ground
    std::vector<float> pressure;     // kPa, impact pressure; empty if a density is unknown
    std::vector<std::uint32_t>
        arrival;  // ticks done when that layer was first kVisible deep; kNever: not yet
    static constexpr float kVisible = 0.01f;  // m
    static constexpr std::uint32_t kNever = 0xffff'ffff;
};

// Finds the maxima of a world, and how much moves in it. Costs what the tiles cost that were written since the last look and where anything rolls.
class PeakWatch {
  public:
    PeakWatch(const sim::State& state, const std::optional<Densities>& densities);

    // Looks at a world, at its start and after every tick; takes note in the world's tiles of what was looked at.
    void see(sim::State& state);
    // Continues from maxima found earlier.
    void go_on(const Peaks& peaks) { peaks_ = peaks; }

    const Peaks& peaks() const { return peaks_; }
    // Vertices whose rolling layer was not empty at the last look.
    std::size_t active_cells() const { return active_.cells; }
    // The kinetic energy of all that moved at the last look and was at least Peaks::kVisible deep: the sum of R |v|², v
    // along the slope, in kEnergyUnit. A whole number, so that it is the same in whatever order it was summed.
    std::int64_t energy() const { return active_.energy; }
    static constexpr double kEnergyUnit = 1.0 / 1024;  // m³/s²; a cell of 128 m at 300 m/s has 1.2e10

  private:
    struct Active {
        std::size_t cells = 0;
        std::int64_t energy = 0;  // kEnergyUnit
    };
    Active see_tile(const sim::View& world, std::uint32_t ticks, int x0, int x1, int y0, int y1);

    Peaks peaks_;
    std::optional<Densities> densities_;
    std::vector<Active> active_in_tile_;
    Active active_;
};

}  // namespace game
