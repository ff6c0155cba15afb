#pragma once

#include <cstdint>

namespace sim {

// The next bits by chance (splitmix64).
inline std::uint32_t next_bits(std::uint64_t& state) {
    std::uint64_t z = state += 0x9E3779B97F4A7C15ull;
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9ull;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EBull;
    return static_cast<std::uint32_t>((z ^ (z >> 31)) >> 32);
}

// The first of them from a seed.
inline std::uint32_t mixed(std::uint64_t seed) {
    return next_bits(seed);
}

// These as a number of 0 to 1, excluding 1.
inline float share_of(std::uint32_t bits) {
    return static_cast<float>(bits >> 8) / 16777216.f;
}

}  // namespace sim
