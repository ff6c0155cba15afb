#pragma once

#include <cstdint>
#include <vector>

#include "sim/core/grid.h"
#include "sim/world/forward.h"

// The smoothed ground b + s, from which the models with momentum take inclination and bend: h = b + d under a
// Gaussian of standard deviation σ in both directions.
//
//     σ = 7 m, but at most 6 Δx        what is narrower than a flow is thick does not turn it
//     s = d + Σ_k w_k (h_{x+k} + h_{x−k} − 2 h_x), along x, then y; without pairs that cross the border
//
// b is natural ground: earth that was sculpted, and buildings, turn a flow as they are, not smoothed.
//
// A plane stays a plane up to the border. s follows digs, pours, erosion and deposits by tick number: it is found
// anew before every kTicksPerSmoothing-th tick, wherever the ground may have changed since. So a replay depends on
// nothing else.
//
// Heights are rounded to quanta and weights to 2⁻¹¹, so that sums in double are exact and their order does not
// matter: a transposed world stays the transposed world, bit by bit.

namespace sim {
struct Tiles;
class Workers;
}  // namespace sim

namespace sim::momentum {

inline constexpr int kTicksPerSmoothing = 15;

class GroundSmoother {
  public:
    // Allocates all that it needs for a world.
    GroundSmoother(const Grid& grid, int tile_width, int tile_height, int threads);

    // Finds s in all tiles that are unsmoothed or within reach of one, and wakes them.
    void smooth(State& state, Workers& workers);

    // Finds s everywhere.
    template <class Number>
    static void smooth_all(Layers<Number>& layers);

  private:
    std::vector<double> weights_;      // w_1 … w_reach
    std::vector<std::uint8_t> stale_;  // of each tile
    std::vector<std::size_t> tiles_;   // the numbers of those that are
    std::size_t most_work_;            // values for each thread
    std::vector<double> work_;
};

}  // namespace sim::momentum
