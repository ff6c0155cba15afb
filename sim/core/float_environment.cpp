#include "sim/core/float_environment.h"

#include <limits>

namespace sim {

std::optional<std::string_view> float_environment_fault() {
    // Volatile, so that this thread computes it and not the compiler.
    volatile float least = std::numeric_limits<float>::min(),
                   denormal = std::numeric_limits<float>::denorm_min();
    if (least * 0.5f == 0 || denormal == 0) return "denormal numbers are flushed to zero";
    volatile float one = 1, half = 0x1p-24f,
                   more = 0x1.8p-24f;  // 1/2 and 3/4 of a unit in the last place of 1
    if (one + half != 1 || one + more != 1 + 0x1p-23f) return "numbers are not rounded to nearest";
    return std::nullopt;
}

}  // namespace sim
