#pragma once

#include <chrono>
#include <cstdint>

namespace game {

// The year and week of ISO 8601 of a day, as 202649: weeks begin on Monday, and the first of a year has its first Thursday.
constexpr std::int64_t week_of(std::chrono::sys_days day) {
    using namespace std::chrono;
    const sys_days thursday = day - (weekday(day) - Monday) + days(3);
    const year year = year_month_day(thursday).year();
    return std::int64_t{static_cast<int>(year)} * 100 +
           (thursday - sys_days(year / January / 1)).count() / 7 + 1;
}

// This week's, by UTC, so that it is the same one everywhere.
inline std::int64_t this_week() {
    return week_of(std::chrono::floor<std::chrono::days>(std::chrono::system_clock::now()));
}

}  // namespace game
