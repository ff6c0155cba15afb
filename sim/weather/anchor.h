#pragma once

#include <cstdint>

namespace sim {
struct State;
}

namespace sim::weather {

// Weather and flow take turns. While weather acts, d₀, S₀ and the smoothed ground are left behind.

// Makes d₀ that of d before the first tick of a flow. Returns whether it was another: then the caller finds S₀ and the smoothed
// ground anew, so that nothing starts of itself.
bool anchor(State& state);

// Ends a slide that only creeps: when 20 s after its release the motion is under 5 % of its greatest, or after 150 s, what
// still rolls is settled. Call at the end of a tick of a flow, when its mass is counted; count it again if this returns true.
bool settle_creep(State& state);

// Call when nothing rolls any more after a tick of a flow. What it changed has no slab now: it is a base.
void reconcile(State& state);

}  // namespace sim::weather
