#pragma once

#include "sim/momentum/fields.h"

// Water in the pores of the standing layer carries a share of the weight, and friction acts on the rest, the effective
// stress (Terzaghi 1943):
//
//     f = 1 − m ρ_w/ρ          m: share of the layer's depth that is saturated (world/things.h)
//
// A slope of tangent S with friction μ fails at S = μ f, the infinite slope with flow parallel to it. For
// ρ, the density of wet soil, this is the criterion of SHALSTAB (Montgomery and Dietrich 1994).
//
//     start       natural and loose ground start at f times their slope, before forest and nets hold it: roots also hold
//                 in wet ground
//     friction    of a layer at a wet vertex f times its friction, moving and at rest: what runs over it loads the bed
//                 faster than it drains
//     erosion     begins at f times its slope: wet beds are entrained more easily (Iverson et al. 2011)

namespace sim::momentum {

// f at a vertex of a world with things; exactly 1 where it is dry.
template <class Number, class S = Scalar<Number>>
[[gnu::always_inline]] inline Number effective_share(const S* water, int i, const Constants<S>& c) {
    return Number(1) - c.buoyancy * at<Number>(water, i);
}

}  // namespace sim::momentum
