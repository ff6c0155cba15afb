#include "sim/simd/instruction_set.h"

namespace sim {

bool has(InstructionSet set) {
#if defined(__clang__)
    // With libstdc++ 12, clang 14 inverts the masks of 512-bit lanes.
    if (set == InstructionSet::kX86_64_v4) return false;
#endif
#if defined(__x86_64__)
    switch (set) {
        case InstructionSet::kBaseline:
            break;
        case InstructionSet::kX86_64_v3:
            return __builtin_cpu_supports("avx2") && __builtin_cpu_supports("bmi2") &&
                   __builtin_cpu_supports("fma");
        case InstructionSet::kX86_64_v4:
            return has(InstructionSet::kX86_64_v3) && __builtin_cpu_supports("avx512f") &&
                   __builtin_cpu_supports("avx512vl") && __builtin_cpu_supports("avx512dq") &&
                   __builtin_cpu_supports("avx512bw") && __builtin_cpu_supports("avx512cd");
    }
#endif
    return set == InstructionSet::kBaseline;
}

InstructionSet best_instruction_set() {
    for (const auto set : {InstructionSet::kX86_64_v4, InstructionSet::kX86_64_v3})
        if (has(set)) return set;
    return InstructionSet::kBaseline;
}

std::string_view to_string(InstructionSet set) {
#if defined(__x86_64__)
    constexpr std::string_view kBaseline = "x86-64-v2";
#elif defined(__aarch64__)
    constexpr std::string_view kBaseline = "aarch64-neon";
#else
    constexpr std::string_view kBaseline = "baseline";
#endif
    constexpr std::string_view kNames[] = {kBaseline, "x86-64-v3", "x86-64-v4"};
    return kNames[static_cast<std::size_t>(set)];
}

}  // namespace sim
