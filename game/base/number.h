#pragma once

#include <charconv>
#include <cmath>
#include <cstddef>
#include <cstdlib>
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
    std::string_view unit = {};  // "m", "ticks"; empty or "1": a bare number
};

// Parses the whole of `text` as a decimal number, in any locale: an optional "-", and for a real number "."
// and an exponent. None if there are other characters, if the type cannot hold the number, or for infinity or
// NaN.
template <class Number>
std::optional<Number> number_from(std::string_view text) {
    Number number{};
    if (text.empty()) return std::nullopt;
#if defined(_LIBCPP_VERSION)
    if constexpr (std::is_floating_point_v<Number>) {  // libc++ 19 has std::from_chars of whole numbers alone
        if (text.front() == '+' || text.find_first_not_of("-+.0123456789eE") != text.npos)
            return std::nullopt;
        const std::string whole(text);
        char* stopped = nullptr;
        number = static_cast<Number>(std::strtod(whole.c_str(), &stopped));
        if (stopped != whole.c_str() + whole.size() || !std::isfinite(number)) return std::nullopt;
        return number;
    } else
#endif
    {
        const char* end = text.data() + text.size();
        const auto [stopped, error] = std::from_chars(text.data(), end, number);
        if (error != std::errc() || stopped != end) return std::nullopt;
        if constexpr (std::is_floating_point_v<Number>)
            if (!std::isfinite(number)) return std::nullopt;
        return number;
    }
}

// "8 to 4096 squares"
template <class Number>
std::string to_text(const Range<Number>& range) {
    const bool bare = range.unit.empty() || range.unit == "1";
    return fmt::format("{} to {}{}{}", range.least, range.most, bare ? "" : " ", bare ? "" : range.unit);
}

// "0.5" of "0,5", as many languages write it; empty if the text is no such number.
std::string with_decimal_point(std::string_view text);

// The same within a range. The error names the text and the accepted range.
template <class Number>
tl::expected<Number, std::string> number_from(std::string_view text, const Range<Number>& range) {
    const auto number = number_from<Number>(text);
    if (number && *number >= range.least && *number <= range.most) return *number;
    std::string pointed;
    if constexpr (!std::is_integral_v<Number>) pointed = with_decimal_point(text);
    return tl::unexpected(fmt::format("'{}' is not a {} from {}{}{}", text,
                                      std::is_integral_v<Number> ? "whole number" : "number", to_text(range),
                                      pointed.empty() ? "" : "; write a decimal point: ", pointed));
}

}  // namespace game
