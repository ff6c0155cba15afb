#include "sim/front/fit_kernel.h"

// For what every processor of a kind has, on x86-64 v2 and on aarch64 NEON: 2 lanes.

namespace sim::front::fit {

const Kernels kKernels_baseline = Fit<stdx::simd<double, stdx::simd_abi::deduce_t<double, 2>>>::kAll;

}  // namespace sim::front::fit
