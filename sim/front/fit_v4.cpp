#include "sim/front/fit_kernel.h"

// For x86-64-v4: 4 lanes.

namespace sim::front::fit {

const Kernels kKernels_v4 = Fit<stdx::simd<double, stdx::simd_abi::deduce_t<double, 4>>>::kAll;

}  // namespace sim::front::fit
