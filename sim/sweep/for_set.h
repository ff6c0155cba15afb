#pragma once

#include "sim/sweep/sweep.h"

namespace sim {

// Of what there is for each instruction set, that for `set`.
template <class Kernels>
const Kernels& for_set(InstructionSet set, const Kernels& v2, const Kernels& v3, const Kernels& v4) {
    switch (set) {
        case InstructionSet::kX86_64_v2:
            break;
        case InstructionSet::kX86_64_v3:
            return v3;
        case InstructionSet::kX86_64_v4:
            return v4;
    }
    return v2;
}

}  // namespace sim
