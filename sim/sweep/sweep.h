#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "sim/bcre/constants.h"
#include "sim/core/activity.h"
#include "sim/momentum/fields.h"
#include "sim/simd/instruction_set.h"
#include "sim/world/outlets.h"

// A sub-step in one sweep over the rows, many vertices at a time. Runs the stages of the plain step
// (bcre/stages.h, momentum/stages.h) without whole fields between them. Results are bit-identical.
//
// This header has only pointers and numbers. kernel.cpp is compiled for instruction sets that a machine may
// lack, so it must not share a function with the rest of the program.

namespace sim::sweep {

// A sub-step's world as the sweep sees it: pointers to vertex (0, 0), rows `stride` apart.
struct Ground {
    int nx, ny;
    std::ptrdiff_t stride;
    float *bedrock, *depth, *rolling, *velocity_x, *velocity_y, *first_slope, *first_depth, *smooth_depth;
    struct Things {
        float *natural, *drag, *detrain, *hold, *net_depth, *wall_x, *wall_y, *water;
        float* floor;
        std::ptrdiff_t floor_stride;  // 0: one row for all
    };
    bool has_things;
    Things things;                  // none, unless has_things
    std::array<Border, 4> borders;  // by Side
    Outlets::View outlets;
    Model model;
    Scheme scheme;
    bcre::Constants<float> bcre;
    momentum::Constants<float> momentum;

    int tile_width, tile_height, tile_columns;
    std::uint8_t* active;  // of each tile, as Activity
};

// A rectangle of vertices that one thread sweeps, x0 … x1-1 by y0 … y1-1. Its rows change in place while
// other threads sweep adjacent rows, so rows outside the job were copied before: kApron on each side. Along x
// a job has only sleeping tiles beside it. A tile is at least twice kBeside wide, so two jobs do not overlap.
// Stages read fewer than kBeside vertices outside. kBeside fills a cache line, so lanes stay aligned.
inline constexpr int kApron = 5, kBeside = kRowPadding;
struct Job {
    int x0, x1, y0, y1;
    struct Apron {  // x = 0 of the copied row at y0, for rows below it, and at y1, for rows above it
        float *below, *above;
    };
    Apron depth, rolling, velocity_x, velocity_y;
};

// Work rows of a thread, each `stride` floats. bcre-inertial needs the most: 164.
inline constexpr int kWorkRows = 192;

// What a sub-step books besides the layers.
struct Booked {
    std::int64_t drained = 0;  // mass that left the world, in quanta
    std::int64_t limited = 0;  // vertices whose speed was limited (State::limited)
};

// Functions compiled for each instruction set (kernel.cpp).
struct Kernels {
    // Sweeps a job through one sub-step. `work` points to x = 0 of the first work row, `active` to a byte for
    // each run of lanes in a row, all 0.
    Booked (*sweep)(const Ground& ground, const Job& job, float* work, std::uint8_t* active);
    // Computes the velocity for views at the end of a tick; 0 where the rolling layer is empty.
    void (*velocity)(const Ground& ground, const Job& job, float* work);
    // Returns the exact sum of a layer in quanta, on `width` by `height` vertices from `first` on, rows
    // `stride` apart.
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

// Returns the kernels for `set`, which this machine must support.
inline const Kernels& kernels_for(InstructionSet set) {
    return with_instruction_set(set, [](auto its) -> const Kernels& { return kernels<its()>(); });
}

}  // namespace sim::sweep
