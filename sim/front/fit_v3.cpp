#include "sim/front/fit_kernel.h"

// For x86-64-v3: 4 lanes.

namespace sim::front::fit {

const Kernels kKernels_v3 = Fit<stdx::simd<double, stdx::simd_abi::deduce_t<double, 4>>>::kAll;

}  // namespace sim::front::fit
