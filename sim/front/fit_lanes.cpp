#include "sim/front/fit_lanes.h"

namespace sim::front::fit {

const Kernels& kernels_for(InstructionSet set) {
    switch (set) {
        case InstructionSet::kX86_64_v2:
            break;
        case InstructionSet::kX86_64_v3:
            return kKernels_v3;
        case InstructionSet::kX86_64_v4:
            return kKernels_v4;
    }
    return kKernels_v2;
}

}  // namespace sim::front::fit
