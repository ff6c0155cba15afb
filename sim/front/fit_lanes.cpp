#include "sim/front/fit_lanes.h"

#include "sim/sweep/for_set.h"

namespace sim::front::fit {

const Kernels& kernels_for(InstructionSet set) {
    return for_set(set, kKernels_v2, kKernels_v3, kKernels_v4);
}

}  // namespace sim::front::fit
