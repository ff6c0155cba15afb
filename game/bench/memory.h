#pragma once

#include <cstddef>

namespace game {

// Bytes of this program in main memory: now, and the maximum since forget_peak() or the start. 0 if the
// system does not report them. They include GL's own memory if the processor draws.
std::size_t resident_bytes();
std::size_t peak_bytes();
void forget_peak();  // also returns free memory to the system

}  // namespace game
