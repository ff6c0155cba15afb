#include "render/view/sun_position.h"

#include <algorithm>
#include <cmath>

#include <glm/trigonometric.hpp>

namespace render {
namespace {

constexpr double kSecondsPerDay = 86400;
constexpr double kUnixOf2000 = 946728000;  // 2000-01-01 12:00 UTC, the epoch of the formulas
constexpr double kDaysPerCentury = 36525;

double sine(double degrees) {
    return std::sin(glm::radians(degrees));
}
double cosine(double degrees) {
    return std::cos(glm::radians(degrees));
}

// How much the air lifts a source at a geometric elevation, degrees: formula 16.4 of Meeus (1998), which is
// for sources that can be seen. Lower down it fades, so that dusk, whose phases are geometric, has no jump.
double refraction(double elevation_deg) {
    constexpr double kVisible = -1, kGeometric = -6;
    const double h = std::max(elevation_deg, kVisible);
    const double lift = 1.02 / 60 / std::tan(glm::radians(h + 10.3 / (h + 5.11)));
    return lift * std::clamp((elevation_deg - kGeometric) / (kVisible - kGeometric), 0.0, 1.0);
}

}  // namespace

// The low-accuracy position of the sun (0.01 degrees) and the sidereal time of Meeus (1998), chapters 25 and
// 12. The difference of UTC to terrestrial and to universal time is neglected: it moves the sun by less than
// 0.005 degrees.
Light sun_position(double latitude_deg, double longitude_deg, double unix_s) {
    const double days = (unix_s - kUnixOf2000) / kSecondsPerDay;
    const double t = days / kDaysPerCentury;

    const double mean_longitude = 280.46646 + t * (36000.76983 + t * 0.0003032);
    const double anomaly = 357.52911 + t * (35999.05029 - t * 0.0001537);
    const double centre = (1.914602 - t * (0.004817 + t * 0.000014)) * sine(anomaly) +
                          (0.019993 - t * 0.000101) * sine(2 * anomaly) + 0.000289 * sine(3 * anomaly);
    const double node = 125.04 - t * 1934.136;  // of the moon's orbit, for aberration and nutation
    const double ecliptic = mean_longitude + centre - 0.00569 - 0.00478 * sine(node);
    const double obliquity = 23.4392911 - t * 0.0130042 + 0.00256 * cosine(node);

    const double right_ascension =
        glm::degrees(std::atan2(cosine(obliquity) * sine(ecliptic), cosine(ecliptic)));
    const double declination = glm::degrees(std::asin(sine(obliquity) * sine(ecliptic)));
    const double sidereal = 280.46061837 + 360.98564736629 * days + t * t * 0.000387933;
    const double hour = sidereal + longitude_deg - right_ascension;  // 0 at solar noon, 90 six hours later

    const double east = -cosine(declination) * sine(hour);
    const double north =
        sine(declination) * cosine(latitude_deg) - cosine(declination) * cosine(hour) * sine(latitude_deg);
    const double up =
        sine(declination) * sine(latitude_deg) + cosine(declination) * cosine(hour) * cosine(latitude_deg);
    const double azimuth = glm::degrees(std::atan2(east, north));
    const double elevation = glm::degrees(std::atan2(up, std::hypot(east, north)));
    return {azimuth < 0 ? azimuth + 360 : azimuth, elevation + refraction(elevation)};
}

}  // namespace render
