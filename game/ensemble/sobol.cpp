#include "game/ensemble/sobol.h"

#include <array>
#include <cstddef>

#include "sim/core/check.h"

namespace game {
namespace {

constexpr int kBits = 32;

// Degree and inner coefficients of a primitive polynomial, and the first direction numbers.
struct Polynomial {
    int degree;
    unsigned inner;
    std::array<std::uint32_t, 6> first;
};
// Of dimensions 2 to 16; the first one has all direction numbers 1.
constexpr std::array<Polynomial, kMostSobolDimensions - 1> kPolynomials{{{1, 0, {1}},
                                                                         {2, 1, {1, 3}},
                                                                         {3, 1, {1, 3, 1}},
                                                                         {3, 2, {1, 1, 1}},
                                                                         {4, 1, {1, 1, 3, 3}},
                                                                         {4, 4, {1, 3, 5, 13}},
                                                                         {5, 2, {1, 1, 5, 5, 17}},
                                                                         {5, 4, {1, 1, 5, 5, 5}},
                                                                         {5, 7, {1, 1, 7, 11, 19}},
                                                                         {5, 11, {1, 1, 5, 1, 1}},
                                                                         {5, 13, {1, 1, 1, 3, 11}},
                                                                         {5, 14, {1, 3, 5, 5, 31}},
                                                                         {6, 1, {1, 3, 3, 9, 7, 49}},
                                                                         {6, 13, {1, 1, 1, 15, 21, 21}},
                                                                         {6, 16, {1, 3, 1, 13, 27, 49}}}};

using Directions = std::array<std::uint32_t, kBits>;

constexpr Directions directions_of(int dimension) {
    Directions v{};
    if (dimension == 0) {
        for (int i = 0; i < kBits; ++i) v[static_cast<std::size_t>(i)] = 1u << (kBits - 1 - i);
        return v;
    }
    const Polynomial& p = kPolynomials[static_cast<std::size_t>(dimension - 1)];
    const auto s = static_cast<std::size_t>(p.degree);
    for (std::size_t i = 0; i < s; ++i) v[i] = p.first[i] << (kBits - 1 - static_cast<int>(i));
    for (std::size_t i = s; i < v.size(); ++i) {
        v[i] = v[i - s] ^ (v[i - s] >> p.degree);
        for (std::size_t k = 1; k < s; ++k)
            if ((p.inner >> (s - 1 - k)) & 1u) v[i] ^= v[i - k];
    }
    return v;
}

constexpr std::array<Directions, kMostSobolDimensions> kDirections = [] {
    std::array<Directions, kMostSobolDimensions> all{};
    for (int i = 0; i < kMostSobolDimensions; ++i) all[static_cast<std::size_t>(i)] = directions_of(i);
    return all;
}();

// SplitMix64 (Steele and others, 2014): bits that look random.
std::uint64_t mixed(std::uint64_t value) {
    value += 0x9E3779B97F4A7C15u;
    value = (value ^ (value >> 30)) * 0xBF58476D1CE4E5B9u;
    value = (value ^ (value >> 27)) * 0x94D049BB133111EBu;
    return value ^ (value >> 31);
}

}  // namespace

double sobol(std::uint64_t seed, int dimension, std::uint32_t index) {
    CHECK(dimension >= 0 && dimension < kMostSobolDimensions);
    const Directions& v = kDirections[static_cast<std::size_t>(dimension)];
    auto bits = static_cast<std::uint32_t>(mixed(mixed(seed) + static_cast<std::uint64_t>(dimension)) >> 32);
    for (std::size_t i = 0; i < v.size(); ++i)
        if ((index >> i) & 1u) bits ^= v[i];
    return (static_cast<double>(bits) + 0.5) / 4294967296.0;
}

}  // namespace game
