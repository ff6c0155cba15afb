#include "sim/sweep/kernel.h"

// For x86-64-v3: 8 lanes.

namespace sim::sweep {

using Lanes8 = stdx::simd<float, stdx::simd_abi::deduce_t<float, 8>>;

std::int64_t sweep_v3(const Ground& ground, const Job& job, float* work, std::uint8_t* active) {
    return run<Lanes8>(ground, job, work, active);
}

void velocity_v3(const Ground& ground, const Job& job, float* work) {
    run_velocity<Lanes8>(ground, job, work);
}

std::int64_t quanta_v3(const float* first, std::ptrdiff_t stride, int width, int height) {
    return quanta<Lanes8>(first, stride, width, height);
}

}  // namespace sim::sweep
