#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "sim/activity.h"
#include "sim/bcre/constants.h"
#include "sim/inertial/work.h"
#include "sim/outlets.h"

// A sub-step in one sweep over the rows, many vertices at a time: the stages of the plain step
// (bcre/stages.h, inertial/stages.h), and the same bits, without a field between them.
//
// Nothing here is more than pointers and numbers. The files sweep_*.cpp are compiled for instruction sets
// that a machine may lack, so they must not share a function with the rest of the program.

namespace sim {

// What a kernel is compiled for, plainest first. The bits do not depend on it. The baseline is what every
// processor of a kind has: x86-64-v2, or the NEON of aarch64; only x86-64 has more.
enum class InstructionSet { kBaseline, kX86_64_v3, kX86_64_v4 };
#if defined(__x86_64__)
inline constexpr std::array kInstructionSets{InstructionSet::kBaseline, InstructionSet::kX86_64_v3,
                                             InstructionSet::kX86_64_v4};
#else
inline constexpr std::array kInstructionSets{InstructionSet::kBaseline};
#endif
inline constexpr bool kMoreThanBaseline = kInstructionSets.size() > 1;

// The newest that this machine has and this program was built with.
InstructionSet best_instruction_set();
bool has(InstructionSet set);
std::string_view to_string(InstructionSet set);

namespace sweep {

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

// Returns what left the world, in quanta. `work` points to x = 0 of the first work row, `active` to a byte
// for each run of lanes in a row, all 0.
using Sweep = std::int64_t (*)(const Ground& ground, const Job& job, float* work, std::uint8_t* active);
std::int64_t sweep_baseline(const Ground& ground, const Job& job, float* work, std::uint8_t* active);
std::int64_t sweep_v3(const Ground& ground, const Job& job, float* work, std::uint8_t* active);
std::int64_t sweep_v4(const Ground& ground, const Job& job, float* work, std::uint8_t* active);

// The velocity at the end of a tick, for who looks on; 0 where nothing rolls.
using Velocity = void (*)(const Ground& ground, const Job& job, float* work);
void velocity_baseline(const Ground& ground, const Job& job, float* work);
void velocity_v3(const Ground& ground, const Job& job, float* work);
void velocity_v4(const Ground& ground, const Job& job, float* work);

// What a layer holds on `width` by `height` vertices from `first` on, rows `stride` apart, in quanta: exact.
using Quanta = std::int64_t (*)(const float* first, std::ptrdiff_t stride, int width, int height);
std::int64_t quanta_baseline(const float* first, std::ptrdiff_t stride, int width, int height);
std::int64_t quanta_v3(const float* first, std::ptrdiff_t stride, int width, int height);
std::int64_t quanta_v4(const float* first, std::ptrdiff_t stride, int width, int height);

// By the kernel of an instruction set that this machine has.
Quanta quanta_for(InstructionSet set);

}  // namespace sweep
}  // namespace sim
