#include "sim/core/number_text.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

namespace sim {
namespace {

template <class Number>
std::string text_of_number(Number value) {
    constexpr Number kLeast{1e-6f}, kMost{1e12f};
    const Number size = std::abs(value);
    const bool is_plain = size == 0 || (size >= kLeast && size < kMost);
    std::array<char, 64> text;
    const auto written = std::to_chars(text.data(), text.data() + text.size(), value,
                                       is_plain ? std::chars_format::fixed : std::chars_format::general);
    std::string result(text.data(), written.ptr);
    if (!is_plain) return result;

    const auto first = static_cast<std::size_t>(result[0] == '-');
    const std::size_t end = std::min(result.find('.'), result.size());
    if (end - first > 4)
        for (std::size_t at = end; at > first + 3;) result.insert(at -= 3, 1, ' ');
    return result;
}

template <class Number>
std::string text_with_unit(Number value, std::string_view unit) {
    std::string text = text_of_number(value);
    if (unit.empty() || unit == "1") return text;
    return text.append(" ").append(unit);
}

}  // namespace

std::string number_text(double value, std::string_view unit) {
    return text_with_unit(value, unit);
}

std::string number_text(float value, std::string_view unit) {
    return text_with_unit(value, unit);
}

std::string number_text(double value) {
    return text_of_number(value);
}

std::string number_text(float value) {
    return text_of_number(value);
}

}  // namespace sim
