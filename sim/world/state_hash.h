#pragma once

#include <cstdint>
#include <vector>

namespace sim {

class Workers;
struct State;

// 64 bits of all that moves: bedrock, depth, rolling layer, velocity x and y, of a mixed world what of the
// lower material rolls, is settled and is untouched, unpadded and as bits, in blocks of 64 by 32 vertices;
// of a world with weather its four fields; then tick, running sources, what stands in the world if anything does, and of
// weather hour and program. XXH3, whose value is the same on every
// machine; zero and minus zero differ. Parameters are not in it: a number that was set shows as soon as it makes a difference.
std::uint64_t state_hash(const State& state);

// Hashes of a state's blocks as they were last computed. A member of the state, so that a copy of it takes
// along what belongs to its fields. Empty until the first call of update_state_hash.
struct BlockHashes {
    std::uint64_t bedrock = 0;
    bool bedrock_is_stale = false;
    std::vector<std::uint64_t> moving;  // of what moves, row by row
    std::vector<std::uint8_t> stale;    // of each block; all 0 between two calls
};

// The same value as state_hash, in less time from tick to tick: computes only blocks under tiles that were
// opened for writing since its last call (tiles.h). Bedrock changes only where
// things do.
std::uint64_t update_state_hash(State& state, Workers& workers);

}  // namespace sim
