#pragma once

#include <string>
#include <string_view>

namespace game::test {

// Reads `bytes` as a recording, first as they are, then with the chain of each line recomputed as a forger
// would. Reads an accepted recording again after rewriting it. Returns what went wrong, or nothing: either
// everything is kept, or one sentence names the line.
std::string_view fault_of_reading(std::string_view bytes);

// A text with the chain of each line recomputed.
std::string chained_anew(std::string_view bytes);

}  // namespace game::test
