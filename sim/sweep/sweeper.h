#pragma once

#include <vector>

#include "sim/core/aligned.h"
#include "sim/sweep/sweep.h"
#include "sim/world/quanta.h"

namespace sim {

class Workers;
struct State;
struct Tiles;

namespace sweep {

// Distributes the awake tiles among threads and sweeps them. Made once per world; allocates nothing
// afterwards. Keeps no state between sub-steps.
class Sweeper {
  public:
    Sweeper(const State& state, int threads, bool last_tile_first);

    // Runs one sub-step, without commands.
    Booked substep(State& state, Workers& workers, InstructionSet set, Substep<float> sub);

    // Computes the velocity for views, once a tick after its sub-steps.
    void find_velocity(State& state, Workers& workers, InstructionSet set);

  private:
    // Splits the marked tiles into jobs and opens these tiles. The only source of pointers that a kernel
    // writes through.
    Ground open(State& state, const std::vector<std::uint8_t>& marked, int threads, Substep<float> sub);
    void find_jobs(const Grid& grid, Tiles& tiles, const std::vector<std::uint8_t>& marked, int threads);
    void copy_aprons(const State& state, const Job& job) const;
    Ground ground_of(State& state, Substep<float> sub);
    float* work_of(int member);

    bool last_tile_first_;
    Outlets outlets_;
    std::ptrdiff_t stride_;
    AlignedVector<float> aprons_;           // rows of each field on two sides, for each row of tiles
    AlignedVector<float> work_;             // kWorkRows for each thread
    std::vector<std::uint8_t> row_active_;  // a row for each thread
    std::vector<std::uint8_t> active_;      // of each tile, in this sub-step, as Activity
    std::vector<std::uint8_t> stale_;       // of each tile: 1 if its velocity must be computed
    std::vector<Job> jobs_;
    std::vector<Booked> booked_;  // of each job
};

}  // namespace sweep
}  // namespace sim
