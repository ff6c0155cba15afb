#pragma once

#include <algorithm>

#include "sim/front/moving_quadratic.h"
#include "sim/simd/instruction_set.h"

// What is done to every row of a fit (space_time_fit.h), a few at a time. Rows are added up in so many lanes
// on any machine, so that the bits do not depend on it.
//
// Nothing here is more than pointers and numbers, because fit_kernel.cpp is compiled for
// instruction sets that a machine may lack.

namespace sim::front::fit {

inline constexpr int kLanes = 4;

// Of so many rows, how many there are when lanes are filled up with zeros. Arrays below are as long as that.
constexpr int filled_up(int count) {
    return (count + kLanes - 1) / kLanes * kLanes;
}

// Lengths in cells from here on: s = u (y − y₀) − v (x − x₀) along a front, D = u (x − x₀) + v (y − y₀)
// across.
struct LocalFrame {
    double x0, y0;  // m
    double u, v;    // normal, 1/cells
};

// Flips: where they were and when, and which way the front went.
struct Flipped {
    const double *x, *y;         // m
    const double* age;           // s
    const double *east, *north;  // unit
};
struct FlipRows {
    double *s, *D, *age, *weight;
};

// How much a flip weighs: (1 − s²/reach²)³, times what the cosine between the way the front went and this one
// is above one_way, up to 1 at surely.
struct Weighing {
    double east, north;  // unit
    double one_way, surely;
    double reach2;  // > 0
};

// Variance of a flip: that of all, and the square of `model` times the cube of its age in windows.
struct Deviation {
    double window;  // s
    double end;     // windows: what is older does not count
    double all, model;
};

// Edges that a front crosses now: both ends.
struct Crossed {
    const double *x, *y, *beyond_x, *beyond_y;  // m
};
struct CrossingRows {
    double *s, *D, *beyond_s, *beyond_D;
    double* counts;  // 1 or 0
};

// Which count: those whose middle is no farther away, and which go at least so far across. Each weighs as a
// flip there would, over the square of how far across it goes, which is taken to be `deviating` at least.
struct Nearness {
    double near2, across, deviating, reach2;
};

using LaneSums = double[MovingQuadratic::Sums<double>::kAll][kLanes];

struct Kernels {
    // Of each key how many are less.
    void (*find_order)(const int* key, int count, int* less);
    // Rows that only fill up weigh nothing, if one_way > 0.
    void (*place_flips)(const LocalFrame&, const Weighing&, const Flipped&, int count, const FlipRows&);
    // Rows are the newest first.
    void (*add_flips)(const Deviation&, const FlipRows&, int count, LaneSums&);
    // Those count whose `counts` is 1 already, and that are near.
    void (*place_crossings)(const LocalFrame&, const Nearness&, const Crossed&, int count,
                            const CrossingRows&, LaneSums&);
    // How far ends lie on the wrong side of D = c₀ + c₁ s + c₂ s²/2: those here below it, those beyond above;
    // those that do not count are right. The most.
    double (*find_wrong)(const double (&c)[3], const CrossingRows&, int count, double* here, double* beyond);
};
template <InstructionSet set>
const Kernels& kernels();

// Of an instruction set that this machine has. Rows are too short for the vectors of x86-64-v4, which has the
// kernels of v3.
inline const Kernels& kernels_for(InstructionSet set) {
    return with_instruction_set(std::min(set, InstructionSet::kX86_64_v3), [](auto its) -> const Kernels& {
        return kernels<std::min(its(), InstructionSet::kX86_64_v3)>();
    });
}

}  // namespace sim::front::fit
