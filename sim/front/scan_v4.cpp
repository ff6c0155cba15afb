#include "sim/front/scan_kernel.h"

// For x86-64-v4: 16 lanes.

namespace sim::front::scan {

const Kernels kKernels_v4 = Scan<stdx::simd<float, stdx::simd_abi::deduce_t<float, 16>>>::kAll;

}  // namespace sim::front::scan
