#pragma once

#include <cstdint>

namespace support {

// How often this thread has called operator new, libraries' calls included. Linking the library
// test_allocations replaces operator new of the whole program.
std::int64_t allocations();
// The same of all threads together.
std::int64_t allocations_of_all_threads();

}  // namespace support
