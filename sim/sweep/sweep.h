#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "sim/bcre/constants.h"
#include "sim/core/activity.h"
#include "sim/inertial/fields.h"
#include "sim/simd/instruction_set.h"
#include "sim/world/outlets.h"

// A sub-step in one sweep over the rows, many vertices at a time: the stages of the plain step
// (bcre/stages.h, inertial/stages.h), and the same bits, without a field between them.
//
// Nothing here is more than pointers and numbers. kernel.cpp is compiled for instruction sets that a machine
// may lack, so it must not share a function with the rest of the program.

namespace sim::sweep {

// A sub-step's world as the sweep sees it: pointers to vertex (0, 0), rows `stride` apart.
struct Ground {
    int nx, ny;
    std::ptrdiff_t stride;
    float *bedrock, *depth, *rolling, *velocity_x, *velocity_y, *first_slope, *first_depth;
    std::array<Border, 4> borders;  // by Side
    Outlets::View outlets;
    Model model;
    Scheme scheme;
    bcre::Constants<float> bcre;
    inertial::Constants<float> inertial;

    int tile_width, tile_height, tile_columns;
    std::uint8_t* active;  // of each tile, as Activity
};

// A rectangle of vertices that one thread sweeps, x0 … x1-1 by y0 … y1-1. Its rows change in place while
// others sweep the rows beside it, so what lies beyond was copied before: kApron rows on each side. Along x
// only what sleeps lies beside it, a tile at least: twice kBeside, so that two jobs do not meet in it. Its
// stages read less than kBeside vertices of it; so many fill a cache line, and lanes keep to theirs.
inline constexpr int kApron = 5, kBeside = kRowPadding;
struct Job {
    int x0, x1, y0, y1;
    struct Apron {  // where row y0 would follow on what lies below, and row y1 above; x = 0
        float *below, *above;
    };
    Apron depth, rolling, velocity_x, velocity_y;
};

// Rows that a thread works with, each `stride` floats: the most that a sweep takes is 168, for bcre-inertial.
inline constexpr int kWorkRows = 192;

// What is compiled for each instruction set (kernel.cpp).
struct Kernels {
    // Sweeps a job through one sub-step. Returns what left the world, in quanta. `work` points to x = 0 of
    // the first work row, `active` to a byte for each run of lanes in a row, all 0.
    std::int64_t (*sweep)(const Ground& ground, const Job& job, float* work, std::uint8_t* active);
    // Computes the velocity for views at the end of a tick; 0 where nothing rolls.
    void (*velocity)(const Ground& ground, const Job& job, float* work);
    // What a layer holds on `width` by `height` vertices from `first` on, rows `stride` apart, in quanta:
    // exact.
    std::int64_t (*quanta)(const float* first, std::ptrdiff_t stride, int width, int height);
};
template <InstructionSet set>
const Kernels& kernels();
template <>
const Kernels& kernels<InstructionSet::kBaseline>();
template <>
const Kernels& kernels<InstructionSet::kX86_64_v3>();
template <>
const Kernels& kernels<InstructionSet::kX86_64_v4>();

// Of an instruction set that this machine has.
inline const Kernels& kernels_for(InstructionSet set) {
    return with_instruction_set(set, [](auto its) -> const Kernels& { return kernels<its()>(); });
}

}  // namespace sim::sweep
