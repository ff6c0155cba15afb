#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <optional>

#include "sim/world/mixture.h"
#include "sim/world/params.h"

namespace sim {

// The number of blends of both materials' parameters in a mixed world, 0 to 1 of the lower one.
inline constexpr int kBlends = 33;

inline int nearest_blend(float share) {
    return static_cast<int>(std::floor(share * (kBlends - 1) + 0.5f));
}

// Blends linearly in each parameter; exact at both ends.
inline Params blended(const Params& upper, const Params& lower, int blend) {
    const float share = static_cast<float>(blend) / (kBlends - 1);
    Params params = upper;
    for (const ParamInfo& info : kParams)
        params.*info.value = upper.*info.value * (1 - share) + lower.*info.value * share;
    params.density = upper.density * (1 - share) + lower.density * share;
    return params;
}

// A model's constants for each blend, and the blend of each vertex.
template <class Constants>
struct Blends {
    std::array<Constants, kBlends> constants;
    const Field<std::uint8_t>*flow, *bed;
};

}  // namespace sim
