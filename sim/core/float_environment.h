#pragma once

#include <optional>
#include <string_view>

namespace sim {

// What of this thread's arithmetic is not as IEEE 754 has it by default, and so would break replays without a
// word: another rounding than to nearest, or denormal numbers taken for zero. Libraries switch either on
// behind a program's back. Costs a few nanoseconds; threads begin with the arithmetic of the one that made
// them.
std::optional<std::string_view> float_environment_fault();

}  // namespace sim
