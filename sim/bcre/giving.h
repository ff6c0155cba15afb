#pragma once

#include "sim/bcre/velocity.h"

// Transport, ∂R/∂t + ∇·(R v) = 0, as what each vertex gives to its four neighbours in a sub-step, m:
//
//            N                 R_C ← R_C − (e + w + n + s)_C + (e_W + w_E + n_S + s_N)
//            ↑n
//        W ←w C e→ E           a flux splitting: what passes a face is what either side gives by its own
//            ↓s                velocity, so that from an empty vertex nothing comes
//            S
//
// Each scheme is a file: giving_lax_friedrichs.h, giving_local_lax_friedrichs.h, giving_muscl.h.

namespace sim::bcre {

// No more than there is. Rounding may add a quantum in each direction; with four a vertex keeps four in hand.
template <class Number>
Toward<Number> limited(const Toward<Number>& wanted, const Number& rolling) {
    using S = Scalar<Number>;
    constexpr S kLess = kHasQuanta<Number> ? S(1 - 1e-6) : S(1);  // for the rounding of the products
    const Number all = wanted.sum();
    const Number had = larger(rolling - 4 * kGrain<Number>, Number(0));
    const auto too_much = all > had;
    if (!any(too_much)) return wanted;
    const Number scale = select(too_much, had * kLess / larger(all, Number(1e-30f)), Number(1));
    return {wanted.east * scale, wanted.west * scale, wanted.north * scale, wanted.south * scale};
}

// In whole quanta, so that both sides of a face book the same.
template <class Number>
Toward<Number> booked(const Toward<Number>& gives, const Constants<Scalar<Number>>& c) {
    return {in_quanta(gives.east, c.dither), in_quanta(gives.west, c.dither),
            in_quanta(gives.north, c.dither), in_quanta(gives.south, c.dither)};
}

// R less what it gave, and then with what its neighbours gave it.
template <class Number>
Number kept(const Number& rolling, const Toward<Number>& given) {
    return rolling - given.sum();
}
template <class Number>
Number with_received(const Number& kept, const Number& from_west, const Number& from_east,
                     const Number& from_south, const Number& from_north) {
    return kept + ((from_west + from_east) + (from_south + from_north));
}

}  // namespace sim::bcre
