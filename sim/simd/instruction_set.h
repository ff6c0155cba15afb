#pragma once

#include <array>
#include <string_view>
#include <type_traits>

namespace sim {

// The instruction sets that kernels are compiled for, oldest first. Results do not depend on the set. The
// baseline is available on every processor of an architecture: x86-64-v2, or the NEON of aarch64. Only x86-64
// has more.
enum class InstructionSet { kBaseline, kX86_64_v3, kX86_64_v4 };
#if defined(__x86_64__)
inline constexpr std::array kInstructionSets{InstructionSet::kBaseline, InstructionSet::kX86_64_v3,
                                             InstructionSet::kX86_64_v4};
#else
inline constexpr std::array kInstructionSets{InstructionSet::kBaseline};
#endif
inline constexpr bool kMoreThanBaseline = kInstructionSets.size() > 1;

// The newest set that this machine has and this program was built with.
InstructionSet best_instruction_set();
bool has(InstructionSet set);
std::string_view to_string(InstructionSet set);

// Number of float lanes in a vector of the set.
constexpr int float_lanes(InstructionSet set) {
    return set == InstructionSet::kX86_64_v4 ? 16 : set == InstructionSet::kX86_64_v3 ? 8 : 4;
}

// A set known at compile time, as a value.
template <InstructionSet set>
using SetConstant = std::integral_constant<InstructionSet, set>;

// Calls use(SetConstant<set>()), to get from a set known at run time to its kernels. Kernels are one source,
// compiled once for each set (couloir_kernels in sim/CMakeLists.txt).
template <class Use>
decltype(auto) with_instruction_set(InstructionSet set, Use&& use) {
    if constexpr (kMoreThanBaseline) {
        if (set == InstructionSet::kX86_64_v4) return use(SetConstant<InstructionSet::kX86_64_v4>());
        if (set == InstructionSet::kX86_64_v3) return use(SetConstant<InstructionSet::kX86_64_v3>());
    }
    return use(SetConstant<InstructionSet::kBaseline>());
}

}  // namespace sim
