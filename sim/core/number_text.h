#pragma once

#include <string>

namespace sim {

// A number in a sentence: the fewest digits that give it back, in groups of three from 10 000 on, without an
// exponent unless it is huge or tiny. "0.5", "1000", "20 000".
std::string number_text(double value);
std::string number_text(float value);

}  // namespace sim
