#pragma once

#include "sim/momentum/fields.h"
#include "sim/simd/exponential.h"

// Friction at the base of a layer of thickness h normal to the slope, pressed down by N per density:
//
//     shear stress per N h    slides   μ(h) = μ + (μ_thin − μ) e^(−h/h_fold)     so that films hold; bcre-inertial only
//                             moves    slides · (1 + f N h/(f N h + |v|ₛ²))      at rest twice as much
//                             sticks   (1 − μ) (1 − e^(−x))/x,  x = h cos θ/h_c  h_c = N₀/ρ g; of a film 1 − μ
//     drag                    ξ(h) = ξ (h/1 m)^p
//
// The exponential is after Pouliquen (1999). f is the R_s⁰ of samosAT (Sampl and Zwinger 2004; .222 in com1DFA), and its drag,
// (ln(h/.05 m)/.43 + 4.13)² g, is 1208 m/s² (h/1 m)^(3/8) within 5 % from .5 to 8 m. Cohesion is that of RAMMS (Bartelt et al.
// 2015). f, h_c and p are 0 unless a material has them, and then cost nothing.

namespace sim::momentum {

template <class Number>
struct Friction {
    Number moves, rests;

    [[gnu::always_inline]] Friction operator*(const Number& share) const {
        return {moves * share, rests * share};
    }
};

// Of a layer with speed √`squared` along the slope, N = `normal` · cos θ.
template <class Number, class S = Scalar<Number>>
[[gnu::always_inline]] inline Friction<Number> friction_of(const Number& h, const Number& cos,
                                                           const Number& squared, const Number& normal,
                                                           const Constants<S>& c) {
    Number slides(c.friction), sticks(0);
    if (c.friction_more > S{0})
        slides = c.friction + c.friction_more * sim::exp(Number(h * -c.per_fold_depth));
    if (c.per_cohesion_depth > S{0}) {
        const Number x = max(h * cos * c.per_cohesion_depth, Number(S(1e-6)));
        sticks = c.cohesion * -sim::expm1(Number(-x)) / x;
    }
    if (!(c.fluidization > S{0})) return {slides + sticks, slides + sticks};
    const Number pressed = c.fluidization * (normal * cos * h);
    const Number more = pressed / max(pressed + squared, Number(S(1e-30)));
    return {slides * (Number(1) + more) + sticks, S(2) * slides + sticks};
}
template <class Number, class S = Scalar<Number>>
[[gnu::always_inline]] inline Number friction_at_rest(const Number& h, const Number& cos,
                                                      const Constants<S>& c) {
    return friction_of(h, cos, Number(0), Number(S(kGravity)), c).rests;
}

// g Δt/ξ(h), s.
template <class Number, class S = Scalar<Number>>
[[gnu::always_inline]] inline Number drag_length_of(const Number& h, const Constants<S>& c) {
    if (c.drag_eighths == 0) return Number(c.drag_length);
    const Number thick = max(h, Number(S(1e-4)));
    if (c.drag_eighths == 8) return c.drag_length / thick;
    const Number half = sqrt(thick), quarter = sqrt(half);
    Number power(1);
    if (c.drag_eighths & 4) power *= half;
    if (c.drag_eighths & 2) power *= quarter;
    if (c.drag_eighths & 1) power *= sqrt(quarter);
    return c.drag_length / power;
}

}  // namespace sim::momentum
