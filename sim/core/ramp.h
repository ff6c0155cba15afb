#pragma once

#include <algorithm>
#include <concepts>
#include <type_traits>

namespace sim {

// 0 up to `from`, 1 from `to` on, smooth between; `from` may be the larger one.
template <std::floating_point Real>
Real ramp(std::type_identity_t<Real> from, std::type_identity_t<Real> to, Real x) {
    const Real t = std::clamp((x - from) / (to - from), Real(0), Real(1));
    return t * t * (3 - 2 * t);
}

}  // namespace sim
