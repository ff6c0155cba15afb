#pragma once

#include <array>
#include <cstddef>

namespace render {

// A day of any year, by the calendar of the northern hemisphere.
struct Date {
    int month = 1;  // 1 to 12
    int day = 1;    // 1 to 31, of the month
    bool operator==(const Date&) const = default;
};

// Days of each month, of a leap year.
inline constexpr std::array kDaysOfMonths{31, 29, 31, 30, 31, 30, 31, 31, 30, 31, 30, 31};
// Of a month; 0 if there is no such month.
constexpr int days_of(int month) {
    return month < 1 || month > 12 ? 0 : kDaysOfMonths[static_cast<std::size_t>(month - 1)];
}

// Of a leap year, 1 for the first of January.
constexpr int day_of_year(Date date) {
    int day = date.day;
    for (int month = 1; month < date.month; ++month) day += days_of(month);
    return day;
}

// How far plants are, in a valley of the Alps, 0 to 1 each. Chosen by eye after the phenological calendar of such places.
struct Season {
    float green = 0;   // of grass: 0 straw, 1 in full growth
    float leaves = 0;  // of broad-leaved trees and larches: 0 bare
    float turned = 0;  // of these leaves: 0 green, 1 yellow and red
    bool operator==(const Season&) const = default;
};
Season season_on(Date date);

}  // namespace render
