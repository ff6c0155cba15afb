#pragma once

#include <cstdint>

namespace sim {

struct State;

// 64 bits of all that moves: bedrock, depth, rolling layer, velocity x and y, unpadded and as bits, in that
// order, of a mixed world what of the lower material rolls, is settled and is untouched, then tick, running
// sources and seed. XXH3, whose value is the same on every machine; zero and minus zero differ. Parameters
// are not in it: a number that was set shows as soon as it makes a difference.
std::uint64_t state_hash(const State& state);

}  // namespace sim
