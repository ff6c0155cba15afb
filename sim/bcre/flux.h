#pragma once

#include "sim/bcre/velocity.h"

// Transport, ∂R/∂t + ∇·(R v) = 0, as what passes each face in a sub-step, m, positive to the east and north:
//
//              F_n              R_C ← R_C + (F_w − F_e) + (F_s − F_n)
//               ↑
//      F_w →    C    → F_e      a flux splitting: each side contributes to F by its own velocity, so nothing
//               ↑               flows out of an empty vertex
//              F_s
//
// A face bears the number of the vertex east or north of it: F_w and F_s are those of C. Each scheme is a
// file: flux_lax_friedrichs.h, flux_local_lax_friedrichs.h, flux_muscl.h.

namespace sim::bcre {

// The reserve of a vertex, m. Rounding may add a quantum at each of its four faces.
template <class Number>
inline constexpr Scalar<Number> kInHand = 4 * kGrain<Number>;

// The most that may flow out of a vertex through all faces, m.
template <class Number>
[[gnu::always_inline]] inline Number spare_of(const Number& rolling) {
    return max(rolling - kInHand<Number>, Number(0));
}

// The factor, at most 1, that limits the wanted outflow `all` of a vertex to what it can spare.
template <class Number>
[[gnu::always_inline]] inline Number outflow_share(const Number& all, const Number& rolling) {
    using S = Scalar<Number>;
    constexpr S kLess = kHasQuanta<Number> ? S(1 - 1e-6) : S(1);  // for the rounding of the products
    const Number had = spare_of(rolling);
    const auto too_much = all > had;
    if (!any(too_much)) return Number(1);
    return select(too_much, had * kLess / select(too_much, all, Number(1)), Number(1));
}

// Rounds to whole quanta, symmetrically for both signs.
template <class Number>
[[gnu::always_inline]] inline Number quantised(const Number& flux, const Constants<Scalar<Number>>& c) {
    return with_its_sign(flux, [&](const Number& size) { return in_quanta(size, c.dither); });
}

template <class Number>
[[gnu::always_inline]] inline Number carried(const Number& rolling, const Number& west, const Number& east,
                                             const Number& south, const Number& north) {
    return rolling + ((west - east) + (south - north));
}

}  // namespace sim::bcre
