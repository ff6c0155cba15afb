#pragma once

#include <cstdint>

#include "sim/simd/instruction_set.h"

// Finds where velocities may jump, many vertices at a time. A detector scans everything in every step,
// whatever the flow does. Results are bits of adjacent vertices, 64 to a word. No jump is missed; some
// results may be smaller jumps.
//
// Only pointers and numbers appear here, because scan_kernel.cpp is compiled for instruction sets that a
// machine may lack.

namespace sim::front::scan {

using Word = std::uint64_t;
inline constexpr int kWord = 64;  // bits

// Velocities are stored as x, y, x, y, …, in m/s, and are finite.
struct Kernels {
    // `other`: vertices of a row whose velocity differs from `before`. `jumped`: those that may have jumped
    // by `least` or more, m/s. Updates `before` for the rest, except for some beside the jumped ones.
    void (*find_changes)(const float* row, float* before, int count, float least, Word* other, Word* jumped);
    // `jumps`: vertices from which velocity may jump by `least` or more, m/s, to the next vertex, to the one
    // in the row `above`, or to the next one there. Only the first `with_next` of `count` vertices have a
    // next one. A vertex is checked only if one of those four may have `changed`; otherwise its bit in
    // `jumps` is kept.
    void (*find_jumps)(const float* row, const float* above, int count, int with_next, float least,
                       const Word* changed, Word* jumps);
    // Exactly the vertices above the level.
    void (*find_above)(const float* scalar, int count, float level, Word* above);
};
template <InstructionSet set>
const Kernels& kernels();
template <>
const Kernels& kernels<InstructionSet::kBaseline>();
template <>
const Kernels& kernels<InstructionSet::kX86_64_v3>();
template <>
const Kernels& kernels<InstructionSet::kX86_64_v4>();

// Kernels of an instruction set that this machine has.
inline const Kernels& kernels_for(InstructionSet set) {
    return with_instruction_set(set, [](auto its) -> const Kernels& { return kernels<its()>(); });
}

}  // namespace sim::front::scan
