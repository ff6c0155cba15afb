#include "sim/front/scan_kernel.h"

// For x86-64-v3: 8 lanes.

namespace sim::front::scan {

const Kernels kKernels_v3 = Scan<stdx::simd<float, stdx::simd_abi::deduce_t<float, 8>>>::kAll;

}  // namespace sim::front::scan
