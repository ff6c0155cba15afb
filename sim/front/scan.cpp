#include "sim/front/scan.h"

namespace sim::front::scan {

const Kernels& kernels_for(InstructionSet set) {
    if constexpr (kMoreThanBaseline) {
        if (set == InstructionSet::kX86_64_v4) return kKernels_v4;
        if (set == InstructionSet::kX86_64_v3) return kKernels_v3;
    }
    return kKernels_baseline;
}

}  // namespace sim::front::scan
