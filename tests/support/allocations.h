#pragma once

#include <cstdint>

namespace support {

// Number of calls of operator new by this thread, including those of libraries. Linking the library
// test_allocations replaces operator new of the whole program.
std::int64_t allocations();
// The same for all threads together.
std::int64_t allocations_of_all_threads();

}  // namespace support
