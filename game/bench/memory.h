#pragma once

#include <cstddef>

namespace game {

// Bytes of this program in main memory: now, and at most since forget_peak() or the beginning. 0 where the
// system does not tell. GL's own are among them where the processor draws.
std::size_t resident_bytes();
std::size_t peak_bytes();
void forget_peak();  // gives back to the system what is free, too

}  // namespace game
