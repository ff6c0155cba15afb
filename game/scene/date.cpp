#include "game/scene/date.h"

#include <algorithm>

#include <fmt/format.h>

namespace game {

std::optional<render::Date> date_from(std::string_view text) {
    const auto is_digit = [&](std::size_t at) { return text[at] >= '0' && text[at] <= '9'; };
    if (text.size() != 5 || text[2] != '-' || !is_digit(0) || !is_digit(1) || !is_digit(3) || !is_digit(4))
        return std::nullopt;
    const auto number = [&](std::size_t at) { return 10 * (text[at] - '0') + (text[at + 1] - '0'); };
    const render::Date date{number(0), number(3)};
    if (date.day < 1 || date.day > render::days_of(date.month)) return std::nullopt;
    return date;
}

std::string to_string(render::Date date) {
    return fmt::format("{:02}-{:02}", date.month, date.day);
}

render::Date date_of(std::int64_t day) {
    render::Date date{1, 1 + static_cast<int>(day % 366)};
    for (; date.day > render::days_of(date.month); ++date.month) date.day -= render::days_of(date.month);
    return date;
}

}  // namespace game
