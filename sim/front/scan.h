#pragma once

#include <cstdint>

#include "sim/simd/instruction_set.h"

// Where velocities may jump, many vertices at a time: what a detector looks at in every step, whatever the
// flow does. Answers are bits of vertices side by side, 64 to a word. None of what is sought is missed; of
// what is found some may be less.
//
// Nothing here is more than pointers and numbers, because scan_kernel.cpp is compiled for
// instruction sets that a machine may lack.

namespace sim::front::scan {

using Word = std::uint64_t;
inline constexpr int kWord = 64;  // bits

// Velocities lie as x, y, x, y, …, m/s, and are finite.
struct Kernels {
    // Which vertices of a row have another velocity than `before`, and which one that has jumped by `least`
    // or more, m/s. Of the others `before` becomes what they are now, but for some that lie beside those.
    void (*find_changes)(const float* row, float* before, int count, float least, Word* other, Word* jumped);
    // From which of `count` vertices, the first `with_next` of which have one beside them, velocity jumps by
    // `least` or more, m/s, to that, to the one in the row `above`, or to the one beside that. Only where
    // one of those four may have `changed` is looked at all; of others the answer is to stand there already.
    void (*find_jumps)(const float* row, const float* above, int count, int with_next, float least,
                       const Word* changed, Word* jumps);
    // Which lie above the level: these and no others.
    void (*find_above)(const float* scalar, int count, float level, Word* above);
};
template <InstructionSet set>
const Kernels& kernels();

// Of an instruction set that this machine has.
inline const Kernels& kernels_for(InstructionSet set) {
    return with_instruction_set(set, [](auto its) -> const Kernels& { return kernels<its()>(); });
}

}  // namespace sim::front::scan
