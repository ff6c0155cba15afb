#pragma once

#include <cstdint>
#include <vector>

namespace sim {

class Workers;
struct State;

// 64 bits of all that moves: bedrock, depth, rolling layer, velocity x and y, of a mixed world what of the
// lower material rolls, is settled and is untouched, unpadded and as bits, in blocks of 64 by 32 vertices;
// then tick, running sources and seed. XXH3, whose value is the same on every machine; zero and minus zero
// differ. Parameters are not in it: a number that was set shows as soon as it makes a difference.
std::uint64_t state_hash(const State& state);

// The same, for one world tick after tick: only blocks that may have changed since the last call are reckoned
// anew, which its tiles know. Whoever changes the state otherwise than by a step wakes what he changed, and
// bedrock stays as it is.
class StateHasher {
  public:
    explicit StateHasher(const State& state);
    std::uint64_t hash(State& state, Workers& workers);

  private:
    std::uint64_t bedrock_;
    std::vector<std::uint64_t> blocks_;  // row by row
    std::vector<std::uint8_t> stale_;    // of each block
};

}  // namespace sim
