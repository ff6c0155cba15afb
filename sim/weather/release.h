#pragma once

#include <cstdint>

namespace sim {
class Workers;
struct State;
}  // namespace sim

namespace sim::weather {

struct Work;

inline constexpr std::int64_t kHoursPerRelease = 12;  // slabs are looked at so often

// Whether slabs are looked at after this many hours.
inline bool is_release_hour(std::int64_t hours) {
    return hours % kHoursPerRelease == 0;
}

// Lets go what is unstable. A crack begins where S < 1 and runs through its neighbours with S < 1.35, at most 200 m; what it
// reaches, as a set, does not depend on any order. Pieces under 2500 m² stay. The slab rolls then, and its tiles are awake.
// Returns whether any did.
bool release(State& state, Work& work, Workers& workers);

}  // namespace sim::weather
