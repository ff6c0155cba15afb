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

// The numbers that an option or a member of a file accepts, both ends included.
template <class Number>
struct Range {
    Number least, most;
    std::string_view unit = {};  // "m", "ticks"; empty: a bare number
};

// The number that the whole of `text` is, in decimal digits: "-" first, and for a real number "." and an
// exponent, whatever the locale. None: anything else around or in it, a number that the type cannot hold,
// infinity or NaN.
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

// The same within a range. Errors: what was given, and what is accepted.
template <class Number>
tl::expected<Number, std::string> number_from(std::string_view text, const Range<Number>& range) {
    const auto number = number_from<Number>(text);
    if (number && *number >= range.least && *number <= range.most) return *number;
    return tl::unexpected(fmt::format("'{}' is not a {} from {}", text,
                                      std::is_integral_v<Number> ? "whole number" : "number",
                                      to_text(range)));
}

}  // namespace game
