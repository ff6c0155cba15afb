#include "sim/front/fit_lanes.h"

namespace sim::front::fit {

const Kernels& kernels_for(InstructionSet set) {
    if constexpr (kMoreThanBaseline) {
        if (set == InstructionSet::kX86_64_v4) return kKernels_v4;
        if (set == InstructionSet::kX86_64_v3) return kKernels_v3;
    }
    return kKernels_baseline;
}

}  // namespace sim::front::fit
