#include "sim/core/float_environment.h"

#include <cfenv>
#include <string>

#if defined(__SSE__)
#include <xmmintrin.h>
#endif

#include <gtest/gtest.h>

#include "sim/core/workers.h"

namespace {

TEST(FloatEnvironment, is_standard_here_and_in_every_thread) {
    sim::Workers workers(3);
    workers.each_band(3, [](int, int) { EXPECT_FALSE(sim::float_environment_fault()); });
}

TEST(FloatEnvironment, reports_other_rounding) {
    for (const int rounding : {FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO}) {
        std::fesetround(rounding);
        const auto fault = sim::float_environment_fault();
        std::fesetround(FE_TONEAREST);
        EXPECT_EQ(fault, "numbers are not rounded to nearest") << rounding;
    }
    EXPECT_FALSE(sim::float_environment_fault());
}

#if defined(__SSE__)
TEST(FloatEnvironment, reports_flushed_denormals) {
    constexpr unsigned kFlushToZero = 0x8000, kDenormalsAreZero = 0x0040;
    const unsigned usual = _mm_getcsr();
    for (const unsigned bit : {kFlushToZero, kDenormalsAreZero}) {
        _mm_setcsr(usual | bit);
        const auto fault = sim::float_environment_fault();
        _mm_setcsr(usual);
        ASSERT_TRUE(fault) << bit;
        EXPECT_TRUE(fault->starts_with("denormal")) << bit;
    }
}
#elif defined(__aarch64__) && defined(__GNUC__) && !defined(__clang__)
TEST(FloatEnvironment, reports_flushed_denormals) {
    constexpr unsigned kFlushToZero = 1u << 24;  // of the register FPCR
    const unsigned usual = __builtin_aarch64_get_fpcr();
    __builtin_aarch64_set_fpcr(usual | kFlushToZero);
    const auto fault = sim::float_environment_fault();
    __builtin_aarch64_set_fpcr(usual);
    ASSERT_TRUE(fault);
    EXPECT_TRUE(fault->starts_with("denormal"));
}
#endif

}  // namespace
