#pragma once

#include <cstdint>

namespace support {

// How often this thread has called operator new, libraries' calls included. Linking the library
// test_allocations replaces operator new of the whole program.
std::int64_t allocations();

}  // namespace support
