#include "sim/weather/sky.h"

#include <algorithm>

namespace sim::weather {
namespace {

constexpr double kUsualCloud = 0.2;
constexpr double kYear = 365, kColdest = 14;     // days; 15 January
constexpr double kYearSwing = 6, kDaySwing = 4;  // K, half of the range
constexpr double kWarmestHour = 14, kNoon = 12;  // o'clock
constexpr double kSineOfTilt = 0.39795,
                 kSolstice = -10.5;  // of the Earth's axis; day of the year, 0 is 1 January

double cosine(double degrees) {
    return direction_of(degrees).y;
}

void set_sun(Sky& sky, const Calendar& calendar, double day, double clock) {
    const double sine = -kSineOfTilt * cosine((day - kSolstice) * 360 / 365.25);  // of the declination
    const double cosine_of_it = std::sqrt(1 - sine * sine);
    const Direction latitude = direction_of(calendar.latitude);  // x: its sine, y: its cosine
    const Direction hour = direction_of((clock - kNoon) * 15);
    sky.sun_up = static_cast<float>(latitude.x * sine + latitude.y * cosine_of_it * hour.y);
    sky.sun = {-cosine_of_it * hour.x, latitude.y * sine - latitude.x * cosine_of_it * hour.y};
}

}  // namespace

Sky sky_of(const Weather& w) {
    Sky sky;
    double warmer = 0, cloud = kUsualCloud, precipitation = 0, wind = 0, from = 0;
    for (std::size_t i = 0; i < w.program.size(); ++i) {
        const auto& [event, until] = w.program[i];
        if (w.hours < static_cast<std::int64_t>(event.at) || w.hours >= until) continue;
        if (event.kind == CommandKind::kStorm) cloud = 1;
        if (event.kind == CommandKind::kTemperature)
            cloud = std::max(cloud, event.cloud);
        else
            sky.event = static_cast<int>(i);
        precipitation += event.precipitation / event.hours;
        warmer += event.warmer;
        if (event.wind_speed > wind) wind = event.wind_speed, from = event.wind_from;
    }
    const Calendar& calendar = w.calendar;
    const double passed = static_cast<double>(w.hours) + 0.5, days = std::floor(passed / 24);
    const double day = calendar.first_day + passed / 24, clock = passed - 24 * days;
    const double season = (calendar.latitude < 0 ? -1 : 1) * cosine((day - kColdest) * 360 / kYear);
    sky.temperature =
        static_cast<float>(calendar.mean_temperature - kYearSwing * season +
                           kDaySwing * (1 - 0.7 * cloud) * cosine((clock - kWarmestHour) * 15) + warmer);
    sky.precipitation = static_cast<float>(precipitation);
    sky.cloud = static_cast<float>(cloud);
    sky.wind = static_cast<float>(wind);
    if (wind > 0) sky.wind_to = {-direction_of(from).x, -direction_of(from).y};
    set_sun(sky, calendar, day, clock);
    return sky;
}

}  // namespace sim::weather
