#include "sim/sweep/kernel.h"

// For x86-64-v4: 16 lanes.

namespace sim::sweep {

using Lanes16 = stdx::simd<float, stdx::simd_abi::deduce_t<float, 16>>;

std::int64_t sweep_v4(const Ground& ground, const Job& job, float* work, std::uint8_t* active) {
    return run<Lanes16>(ground, job, work, active);
}

void velocity_v4(const Ground& ground, const Job& job, float* work) {
    run_velocity<Lanes16>(ground, job, work);
}

std::int64_t quanta_v4(const float* first, std::ptrdiff_t stride, int width, int height) {
    return quanta<Lanes16>(first, stride, width, height);
}

}  // namespace sim::sweep
