#pragma once

#include "sim/bcre/velocity.h"

// Transport, ∂R/∂t + ∇·(R v) = 0, as what passes each face in a sub-step, m, positive to the east and north:
//
//              F_n              R_C ← R_C + (F_w − F_e) + (F_s − F_n)
//               ↑
//      F_w →    C    → F_e      a flux splitting: F is what either side gives by its own velocity, so that
//               ↑               from an empty vertex nothing comes
//              F_s
//
// A face bears the number of the vertex east or north of it: F_w and F_s are those of C. Each scheme is a
// file: flux_lax_friedrichs.h, flux_local_lax_friedrichs.h, flux_muscl.h.

namespace sim::bcre {

// Rounding may add a quantum at each face; with four a vertex keeps four in hand, m.
template <class Number>
inline constexpr Scalar<Number> kInHand = 4 * kGrain<Number>;

// What a vertex can give to all sides together, m.
template <class Number>
[[gnu::always_inline]] inline Number spare_of(const Number& rolling) {
    return max(rolling - kInHand<Number>, Number(0));
}

// By which share a vertex has to give less than the `all` that it wants to give, to give what it can spare.
template <class Number>
[[gnu::always_inline]] inline Number outflow_share(const Number& all, const Number& rolling) {
    using S = Scalar<Number>;
    constexpr S kLess = kHasQuanta<Number> ? S(1 - 1e-6) : S(1);  // for the rounding of the products
    const Number had = spare_of(rolling);
    const auto too_much = all > had;
    if (!any(too_much)) return Number(1);
    return select(too_much, had * kLess / select(too_much, all, Number(1)), Number(1));
}

// In whole quanta, the same for both signs.
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
