#pragma once

#include <optional>
#include <string_view>

namespace sim {

// Describes how this thread's arithmetic differs from the IEEE 754 default, if it does: rounding other than
// to nearest, or denormal numbers flushed to zero. Either would silently break replays, and libraries may
// switch them on. Costs a few nanoseconds. A thread inherits the arithmetic of the thread that started it.
std::optional<std::string_view> float_environment_fault();

}  // namespace sim
