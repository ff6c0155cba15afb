#pragma once

// CHECK(condition) aborts the program if a bug has broken an invariant. It is for bugs alone: bad input and
// machine failures are reported by values (tl::expected, exit codes). Enabled in Debug, CI and sanitizer
// builds, which define COULOIR_CHECKS; elsewhere the condition is compiled but not evaluated.

namespace sim {
[[noreturn]] void check_failed(const char* condition, const char* file, int line);
}

#ifdef COULOIR_CHECKS
#define CHECK(condition) \
    ((condition) ? static_cast<void>(0) : sim::check_failed(#condition, __FILE__, __LINE__))
#else
#define CHECK(condition) static_cast<void>(sizeof(!(condition)))
#endif
