#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <optional>

#include "sim/world/mixture.h"
#include "sim/world/params.h"

namespace sim {

// Of a mixed world: the numbers of both materials, blended in so many proportions, 0 to 1 of the lower one.
inline constexpr int kBlends = 33;

inline int nearest_blend(float share) {
    return static_cast<int>(std::floor(share * (kBlends - 1) + 0.5f));
}

// Linear in each number; exactly the one or the other at the ends.
inline Params blended(const Params& upper, const Params& lower, int blend) {
    const float share = static_cast<float>(blend) / (kBlends - 1);
    Params params = upper;
    for (const ParamInfo& info : kParams)
        params.*info.value = upper.*info.value * (1 - share) + lower.*info.value * share;
    return params;
}

// What the formulas of a model take from the numbers, for each blend, and which one each vertex goes by.
template <class Constants>
struct Blends {
    std::array<Constants, kBlends> constants;
    const Field<std::uint8_t>*flow, *bed;
};

}  // namespace sim
