#include "sim/front/scan_kernel.h"

// For x86-64-v2: 4 lanes.

namespace sim::front::scan {

const Kernels kKernels_v2 = Scan<stdx::simd<float, stdx::simd_abi::deduce_t<float, 4>>>::kAll;

}  // namespace sim::front::scan
