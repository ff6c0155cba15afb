#include "sim/front/fit_kernel.h"

// For x86-64-v2: 2 lanes.

namespace sim::front::fit {

const Kernels kKernels_v2 = Fit<stdx::simd<double, stdx::simd_abi::deduce_t<double, 2>>>::kAll;

}  // namespace sim::front::fit
