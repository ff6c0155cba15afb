#pragma once

#include <charconv>
#include <cmath>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>

#include <fmt/format.h>
#include <tl/expected.hpp>

namespace game {

// The range of numbers that an option or a member of a file accepts, both ends included.
template <class Number>
struct Range {
    Number least, most;
    std::string_view unit = {};  // "m", "ticks"; empty: a bare number
};

// Parses the whole of `text` as a decimal number, in any locale: an optional "-", and for a real number "."
// and an exponent. None if there are other characters, if the type cannot hold the number, or for infinity or
// NaN.
template <class Number>
std::optional<Number> number_from(std::string_view text) {
    Number number{};
    const char* end = text.data() + text.size();
    const auto [stopped, error] = std::from_chars(text.data(), end, number);
    if (text.empty() || error != std::errc() || stopped != end) return std::nullopt;
    if constexpr (std::is_floating_point_v<Number>)
        if (!std::isfinite(number)) return std::nullopt;
    return number;
}

// "8 to 4096 squares"
template <class Number>
std::string to_text(const Range<Number>& range) {
    return fmt::format("{} to {}{}{}", range.least, range.most, range.unit.empty() ? "" : " ", range.unit);
}

// The same within a range. The error names the text and the accepted range.
template <class Number>
tl::expected<Number, std::string> number_from(std::string_view text, const Range<Number>& range) {
    const auto number = number_from<Number>(text);
    if (number && *number >= range.least && *number <= range.most) return *number;
    return tl::unexpected(fmt::format("'{}' is not a {} from {}", text,
                                      std::is_integral_v<Number> ? "whole number" : "number",
                                      to_text(range)));
}

}  // namespace game
