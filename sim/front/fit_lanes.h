#pragma once

#include <algorithm>

#include "sim/front/moving_quadratic.h"
#include "sim/simd/instruction_set.h"

// Operations on all rows of a fit (space_time_fit.h), a few at a time. Rows are summed in a fixed number of
// lanes, so results are bit-identical on every machine.
//
// Only pointers and numbers appear here, because fit_kernel.cpp is compiled for instruction sets that a
// machine may lack.

namespace sim::front::fit {

inline constexpr int kLanes = 4;

// `count` rounded up to whole lanes; the rest is filled with zeros. The arrays below have this length.
constexpr int filled_up(int count) {
    return (count + kLanes - 1) / kLanes * kLanes;
}

// The frame of a piece of front. Lengths are in cells from here on: s = u (y − y₀) − v (x − x₀) along the
// front, D = u (x − x₀) + v (y − y₀) across it.
struct LocalFrame {
    double x0, y0;  // m
    double u, v;    // normal, 1/cells
};

// Flips: where and when each happened, and the direction in which the front went.
struct Flipped {
    const double *x, *y;         // m
    const double* age;           // s
    const double *east, *north;  // unit
};
struct FlipRows {
    double *s, *D, *age, *weight;
};

// Parameters of a flip's weight: (1 − s²/reach²)³ times a factor of the cosine between the direction of that
// flip and this one. The factor rises from 0 at one_way to 1 at surely.
struct Weighing {
    double east, north;  // unit
    double one_way, surely;
    double reach2;  // > 0
};

// Variance of a flip: `all`, plus the square of `model` times the cube of its age in windows.
struct Deviation {
    double window;  // s
    double end;     // windows; older flips do not count
    double all, model;
};

// Both ends of the edges that a front crosses now.
struct Crossed {
    const double *x, *y, *beyond_x, *beyond_y;  // m
};
struct CrossingRows {
    double *s, *D, *beyond_s, *beyond_D;
    double* counts;  // 1 or 0
};

// An edge counts if its middle is within `near` and it goes at least `across` across the front. Its weight is
// that of a flip there, divided by the square of its length across the front, which is at least `deviating`.
struct Nearness {
    double near2, across, deviating, reach2;
};

using LaneSums = double[MovingQuadratic::Sums<double>::kAll][kLanes];

struct Kernels {
    // For each key, counts the keys that are less.
    void (*find_order)(const int* key, int count, int* less);
    // Filler rows get no weight if one_way > 0.
    void (*place_flips)(const LocalFrame&, const Weighing&, const Flipped&, int count, const FlipRows&);
    // Rows are sorted, newest first.
    void (*add_flips)(const Deviation&, const FlipRows&, int count, LaneSums&);
    // Counts rows whose `counts` is already 1 and that are near.
    void (*place_crossings)(const LocalFrame&, const Nearness&, const Crossed&, int count,
                            const CrossingRows&, LaneSums&);
    // Computes how far ends lie on the wrong side of D = c₀ + c₁ s + c₂ s²/2: `here` below it, `beyond` above
    // it. Rows that do not count get 0. Returns the largest.
    double (*find_wrong)(const double (&c)[3], const CrossingRows&, int count, double* here, double* beyond);
};
template <InstructionSet set>
const Kernels& kernels();
template <>
const Kernels& kernels<InstructionSet::kBaseline>();
template <>
const Kernels& kernels<InstructionSet::kX86_64_v3>();

// Kernels of an instruction set that this machine has. x86-64-v4 gets those of v3, because rows are too short
// for its vectors.
inline const Kernels& kernels_for(InstructionSet set) {
    return with_instruction_set(std::min(set, InstructionSet::kX86_64_v3), [](auto its) -> const Kernels& {
        return kernels<std::min(its(), InstructionSet::kX86_64_v3)>();
    });
}

}  // namespace sim::front::fit
