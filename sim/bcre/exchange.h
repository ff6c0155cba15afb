#pragma once

#include "sim/bcre/constants.h"
#include "sim/simd/exponential.h"
#include "sim/stages/slope.h"

// Exchange between the layers: ∂R/∂t = γ R p, ∂h/∂t = −γ R p, with p = S − s_stop and S the slope toward the
// lower neighbours of h (slope.h). In a thick flow only the lowest R_c of the layer reaches the ground:
// γ min(R, R_c) p (Boutreux, Raphaël and de Gennes 1998).
//
// If p changes little in a sub-step, the solution is the exponential R e^(γ p Δt), or R + γ R_c p Δt in a
// thick flow. Otherwise p decreases as material is eroded. With the lower neighbours held fixed this is a
// logistic equation in R, whose solution never takes S past the threshold,
//
//     R ← R / (E + R a φ(aK))      a = γ κ Δt/Δx,  K = R + p Δx/κ,  E = e^(−aK),  φ(u) = (1 − e^(−u))/u
//
// and in a thick flow an exponential in p: p (Δx/κ) (1 − e^(−γ R_c κ Δt/Δx)). κ = √2 is the most that S
// decreases per Δ/Δx of erosion Δ. The actual κ depends on where the lower neighbours lie, and a raised
// vertex may come above a neighbour that was not lower before.

namespace sim::bcre {

inline constexpr double kMostDeposited = -31;  // m in a sub-step; in_quanta can still round it

// The material that begins to roll, m, negative for deposition. Uses the closed forms for a changing p.
template <class Number>
[[gnu::always_inline]] inline Number exchanged_strongly(const Number& rolling, const Number& growth,
                                                        const Constants<Scalar<Number>>& c) {
    using S = Scalar<Number>;
    const Number room = growth * c.room_per_growth;  // p Δx/κ: the erosion that takes S to the threshold
    const Number end = (rolling + room) * c.strong_pace;  // aK
    const Number left = -sim::expm1(-end);                // 1 − E
    const auto tiny = abs(end) < S(1e-6);
    const Number phi = select(tiny, Number(1), left / select(tiny, Number(1), end));
    const Number kept = max((1 - left) + rolling * c.strong_pace * phi, Number(1e-30f));
    const Number of_thin = rolling / kept - rolling;
    const Number moved = select(rolling > c.exchange_depth, growth * c.thick_exchange, of_thin);
    return max(moved, Number(S(kMostDeposited)));
}

// `growth` = γ p Δt.
template <class Number>
[[gnu::always_inline]] inline Number growth_of(const Number& slope_dx, const Constants<Scalar<Number>>& c) {
    return slope_dx * c.growth_per_slope_dx - c.growth_at_level;
}

// The material that begins to roll, in whole quanta, at least −R. `weak_growth` = e^growth − 1 by
// expm1_small(), which gives the result if p changes little. If the growth is not small, neither is
// `weak_growth`, and it only selects the closed form.
template <class Number>
[[gnu::always_inline]] inline Number exchanged(const Number& rolling, const Number& slope_dx,
                                               const Number& weak_growth,
                                               const Constants<Scalar<Number>>& c) {
    const auto changes_much = max(rolling * c.little_per_rolling, weak_growth) > Scalar<Number>(kLittle);
    const Number weak = in_quanta<Number>(rolling * weak_growth, c.dither);  // a small part of R
    if (!any(changes_much)) return weak;
    const Number strong = in_quanta(exchanged_strongly(rolling, growth_of(slope_dx, c), c), c.dither);
    return select(changes_much, max(strong, -rolling), weak);
}

// The exchange of a sub-step at the current rate, m. The second-order scheme averages two of these. If the
// cells are too coarse for the rate, the exchange stops at the amount that takes S to the threshold.
template <class Number>
[[gnu::always_inline]] inline Number exchanged_at_rate(const Number& rolling, const Number& depth,
                                                       const Number& growth,
                                                       const Constants<Scalar<Number>>& c) {
    const Number wanted = growth * min(rolling, Number(c.rate_depth));
    const Number most_deposited = max(-rolling, Number(Scalar<Number>(kMostDeposited)));
    return max(min(wanted, depth), most_deposited);
}

// Moves `amount`, whole quanta and at least −R, from the standing to the rolling layer, but no more than
// `depth`.
template <class Number>
[[gnu::always_inline]] inline void transfer(const Number& amount, Number& depth, Number& rolling) {
    const Number moved = min(amount, depth);
    depth -= moved;
    rolling += moved;
}

}  // namespace sim::bcre
