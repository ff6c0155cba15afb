#include "sim/sweep/kernel.h"

// For what every processor of a kind has, on x86-64 v2 and on aarch64 NEON: 4 lanes.

namespace sim::sweep {

using Lanes4 = stdx::simd<float, stdx::simd_abi::deduce_t<float, 4>>;

std::int64_t sweep_baseline(const Ground& ground, const Job& job, float* work, std::uint8_t* active) {
    return run<Lanes4>(ground, job, work, active);
}

void velocity_baseline(const Ground& ground, const Job& job, float* work) {
    run_velocity<Lanes4>(ground, job, work);
}

std::int64_t quanta_baseline(const float* first, std::ptrdiff_t stride, int width, int height) {
    return quanta<Lanes4>(first, stride, width, height);
}

}  // namespace sim::sweep
