#include "render/view/sun_position.h"

#include <algorithm>
#include <chrono>
#include <cmath>

#include <gtest/gtest.h>

namespace render {
namespace {

constexpr double kObliquity = 23.44;  // degrees, declination of the sun at a solstice

double utc(int year, unsigned month, unsigned day, int hour, int minute, int second = 0) {
    using namespace std::chrono;
    const sys_days date = std::chrono::year(year) / std::chrono::month(month) / std::chrono::day(day);
    return static_cast<double>(
        duration_cast<seconds>(date.time_since_epoch() + hours(hour) + minutes(minute) + seconds(second))
            .count());
}

double from_north(double azimuth_deg) {
    return std::remainder(azimuth_deg, 360);
}

// Reda and Andreas (2004), table A5.1: zenith 50.11162, azimuth 194.34024, at 820 mbar.
TEST(SunPosition, is_that_of_the_example_of_the_solar_position_algorithm) {
    const Light sun = sun_position(39.742476, -105.1786, utc(2003, 10, 17, 19, 30, 30));
    EXPECT_NEAR(sun.elevation_deg, 90 - 50.11162, 0.01);
    EXPECT_NEAR(sun.azimuth_deg, 194.34024, 0.01);
}

// Meeus (1998), example 25.a: declination −7.78507 at 1992-10-13 0h, which is the geometric elevation at the
// North Pole. Refraction adds 0.115 degrees at the South Pole (Bennett 1982: 6.8 minutes of arc).
TEST(SunPosition, has_the_declination_of_the_example_of_meeus) {
    const double then = utc(1992, 10, 13, 0, 0);
    EXPECT_NEAR(sun_position(90, 0, then).elevation_deg, -7.78507, 0.01);
    EXPECT_NEAR(sun_position(-90, 0, then).elevation_deg, 7.78507 + 0.113, 0.01);
}

struct Season {
    double moment;
    double declination;
};

// Published to the minute in the Astronomical Almanac; the last two lie near the ends of the allowed years.
TEST(SunPosition, has_the_declinations_of_equinoxes_and_solstices) {
    const Season seasons[] = {{utc(2024, 3, 20, 3, 6), 0},           {utc(2024, 6, 20, 20, 51), kObliquity},
                              {utc(2024, 9, 22, 12, 44), 0},         {utc(2024, 12, 21, 9, 21), -kObliquity},
                              {utc(2026, 6, 21, 8, 24), kObliquity}, {utc(1900, 3, 21, 1, 39), 0},
                              {utc(2100, 3, 20, 13, 4), 0}};
    for (const Season& season : seasons) {
        // Highest elevation over the day at a place where that is well above the horizon.
        double highest = -90;
        for (int longitude = -180; longitude < 180; ++longitude)
            highest = std::max(highest, sun_position(45, longitude, season.moment).elevation_deg);
        const double noon = 45 + season.declination;
        EXPECT_NEAR(highest, noon + 0.016 / std::tan(noon * 3.14159265 / 180), 0.01) << season.moment;
    }
}

// The equation of time: the sun is 16 min 25 s early at the beginning of November and 14 min 14 s late in the
// middle of February.
TEST(SunPosition, crosses_the_meridian_by_the_equation_of_time) {
    EXPECT_NEAR(sun_position(47, 0, utc(2023, 11, 3, 11, 43, 35)).azimuth_deg, 180, 0.05);
    EXPECT_NEAR(sun_position(47, 0, utc(2023, 2, 11, 12, 14, 14)).azimuth_deg, 180, 0.05);
    EXPECT_NEAR(sun_position(47, 15, utc(2023, 11, 3, 10, 43, 35)).azimuth_deg, 180, 0.05);
    EXPECT_NEAR(sun_position(47, -345, utc(2023, 11, 3, 10, 43, 35)).azimuth_deg, 180, 0.05);
    EXPECT_NEAR(from_north(sun_position(-33, 0, utc(2023, 11, 3, 11, 43, 35)).azimuth_deg), 0, 0.1);
}

struct Horizon {
    double latitude, longitude, moment, azimuth;
};

// Published times of sunrise and sunset to the minute, azimuths to the degree. Then the upper limb is at the
// apparent horizon, so the centre is a radius of 0.27 degrees below it. The sun rises by up to 0.2 in a minute.
TEST(SunPosition, is_at_the_horizon_at_the_published_times_of_sunrise_and_sunset) {
    const Horizon horizons[] = {{51.507, -0.128, utc(2024, 6, 20, 3, 43), 49},       // London
                                {51.507, -0.128, utc(2024, 6, 20, 20, 21), 311},     //
                                {-33.868, 151.209, utc(2024, 12, 20, 18, 41), 119},  // Sydney
                                {-33.868, 151.209, utc(2024, 12, 21, 9, 5), 241}};
    for (const Horizon& at : horizons) {
        const Light sun = sun_position(at.latitude, at.longitude, at.moment);
        EXPECT_NEAR(sun.elevation_deg, -0.27, 0.2) << at.moment;
        EXPECT_NEAR(sun.azimuth_deg, at.azimuth, 1) << at.moment;
    }
}

TEST(SunPosition, moves_from_east_over_the_side_of_the_equator_to_west) {
    const auto at = [](double latitude, int hour) {
        return sun_position(latitude, 0, utc(2024, 3, 20, hour, 7)).azimuth_deg;
    };
    EXPECT_NEAR(at(47, 6), 90, 1);
    EXPECT_NEAR(at(-47, 6), 90, 1);
    EXPECT_NEAR(at(47, 18), 270, 1);
    EXPECT_NEAR(at(-47, 18), 270, 1);
    EXPECT_NEAR(at(47, 9), 135, 15);
    EXPECT_NEAR(at(47, 15), 225, 15);
    EXPECT_NEAR(at(-47, 9), 45, 15);
    EXPECT_NEAR(at(-47, 15), 315, 15);
}

TEST(SunPosition, stays_up_on_a_polar_day_and_down_in_a_polar_night) {
    constexpr double kLatitude = 69.65, kLongitude = 18.96;  // Tromsø
    const Light midnight = sun_position(kLatitude, kLongitude, utc(2024, 6, 20, 22, 46));
    EXPECT_NEAR(from_north(midnight.azimuth_deg), 0, 0.5);
    EXPECT_NEAR(midnight.elevation_deg, kLatitude - 90 + kObliquity + 0.23, 0.03);
    const Light noon = sun_position(kLatitude, kLongitude, utc(2024, 12, 21, 10, 42));
    EXPECT_NEAR(noon.azimuth_deg, 180, 0.5);
    EXPECT_LT(noon.elevation_deg, -2.6);
    for (int hour = 0; hour < 24; ++hour) {
        EXPECT_GT(sun_position(kLatitude, kLongitude, utc(2024, 6, 20, hour, 0)).elevation_deg, 3);
        EXPECT_LT(sun_position(kLatitude, kLongitude, utc(2024, 12, 21, hour, 0)).elevation_deg, -2.6);
    }
}

// Refraction is fitted in four pieces; a frame must not jump where they meet.
TEST(SunPosition, moves_without_jumps_from_night_to_noon) {
    const double start = utc(2024, 3, 20, 5, 0);
    double before = sun_position(0, 0, start).elevation_deg;
    for (int second = 10; second <= 6 * 3600; second += 10) {
        const double now = sun_position(0, 0, start + second).elevation_deg;
        EXPECT_NEAR(now - before, 10 * 360.0 / 86400, 0.012) << second;
        before = now;
    }
}

}  // namespace
}  // namespace render
