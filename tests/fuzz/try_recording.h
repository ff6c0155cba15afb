#pragma once

#include <string_view>

namespace game::test {

// Reads `bytes` as a recording, as they are and, line by line, with the chain that a forger would give them;
// and what was accepted once more as it is written anew. Returns what is wrong with how that went, which is
// nothing: either all is understood and kept, or one sentence names the line.
std::string_view fault_of_reading(std::string_view bytes);

}  // namespace game::test
