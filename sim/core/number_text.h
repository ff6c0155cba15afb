#pragma once

#include <string>
#include <string_view>

namespace sim {

// A number in a sentence: the fewest digits that give it back, in groups of three from 10 000 on, without an
// exponent unless it is huge or tiny. "0.5", "1000", "20 000".
std::string number_text(double value);
std::string number_text(float value);
// With its unit, "0.5 m"; a number without a dimension, whose unit is empty or "1", has none.
std::string number_text(double value, std::string_view unit);
std::string number_text(float value, std::string_view unit);

}  // namespace sim
