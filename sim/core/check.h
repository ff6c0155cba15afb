#pragma once

// CHECK(condition) stops the program where a bug has broken one of our own promises. It is for bugs alone:
// bad input and a failing machine are answered with values (tl::expected, exit codes). On in Debug, CI and
// sanitizer builds, where COULOIR_CHECKS is defined; elsewhere the condition is compiled but not evaluated.

namespace sim {
[[noreturn]] void check_failed(const char* condition, const char* file, int line);
}

#ifdef COULOIR_CHECKS
#define CHECK(condition) \
    ((condition) ? static_cast<void>(0) : sim::check_failed(#condition, __FILE__, __LINE__))
#else
#define CHECK(condition) static_cast<void>(sizeof(!(condition)))
#endif
