#pragma once

#include <cstdint>

namespace sim {

// The grain of mass: depth and rolling layer are whole multiples of it, exact in float32 up to kDeepest. m of
// depth.
inline constexpr float kQuantum = 1.f / 131072.f;  // 2⁻¹⁷ m, 7.6 µm
// Beyond this a layer's float32 no longer holds single quanta. m
inline constexpr float kDeepest = 128.f;

// Where the mass is, in quanta of depth times cells: exact whole numbers, one quantum is kQuantum · dx² m³.
// standing + rolling + out − poured + dug − fallen + melted = initial, always; mass_error() is the deviation.
struct Ledger {
    std::int64_t initial = 0;   // standing and rolling when the world began
    std::int64_t standing = 0;  // as counted last
    std::int64_t rolling = 0;   // as counted last
    std::int64_t out = 0;       // left over a border or into no-data
    std::int64_t poured = 0;    // added by commands
    std::int64_t dug = 0;       // taken by commands
    std::int64_t fallen = 0;    // snow and rain, and snow that a wind brought over a border
    std::int64_t melted = 0;    // water that ran off

    std::int64_t mass_error() const {
        return standing + rolling + out - poured + dug - fallen + melted - initial;
    }
    bool operator==(const Ledger&) const = default;
};

}  // namespace sim
