#pragma once

#include <string_view>

namespace test {

// An example of quadratic JSON parsing: nlohmann's parse() with a callback scans the whole enclosing list at
// the end of each inner list. It verifies the step counter.
void parse_with_callback(std::string_view json);

}  // namespace test
