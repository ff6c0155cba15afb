#include "sim/front/scan_kernel.h"

// For what every processor of a kind has, on x86-64 v2 and on aarch64 NEON: 4 lanes.

namespace sim::front::scan {

const Kernels kKernels_baseline = Scan<stdx::simd<float, stdx::simd_abi::deduce_t<float, 4>>>::kAll;

}  // namespace sim::front::scan
