#include "game/controls/photo.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "render/view/sky_light.h"

namespace game {
namespace {

constexpr double kSensorWidth = 36;                       // mm
constexpr double kShortestLens = 12, kLongestLens = 200;  // mm
constexpr double kNarrowestView = 5, kWidestView = 120;   // degrees, of a camera
constexpr double kDegreesPerHour = 15;
constexpr double kWinter = -13, kSummer = 21;  // degrees, declinations in the middle of February and of July
constexpr float kBrightAsSnow = 0.5f;          // of a layer

glm::dvec3 direction_to(const render::Light& light) {
    const double azimuth = glm::radians(light.azimuth_deg), elevation = glm::radians(light.elevation_deg);
    return {std::sin(azimuth) * std::cos(elevation), std::cos(azimuth) * std::cos(elevation),
            std::sin(elevation)};
}

}  // namespace

double field_of_view_of(double focal_mm, double aspect) {
    return 2 * glm::degrees(std::atan(kSensorWidth / 2 / focal_mm / aspect));
}

double focal_length_of(double field_of_view_deg, double aspect) {
    return kSensorWidth / 2 / (aspect * std::tan(glm::radians(field_of_view_deg) / 2));
}

FocalLengths focal_lengths(double aspect) {
    const double least = std::max(kShortestLens, focal_length_of(kWidestView, aspect));
    return {least, std::max(least, std::min(kLongestLens, focal_length_of(kNarrowestView, aspect)))};
}

PhotoDay photo_day(const Scenario& scenario, std::optional<render::Date> date) {
    const sim::Grid& grid = scenario.grid;
    const auto dx = static_cast<double>(grid.dx);
    PhotoDay day;
    if (const auto place = scenario.georeference.to_lat_lon({(grid.nx - 1) * dx / 2, (grid.ny - 1) * dx / 2}))
        day.latitude_deg = place->latitude;
    const glm::vec3& layer = scenario.look.standing;
    const bool is_snow = std::min({layer.r, layer.g, layer.b}) >= kBrightAsSnow;
    // Cooper (1969).
    const double usual =
        date      ? 23.45 * std::sin(glm::radians(360.0 / 365 * (284 + render::day_of_year(*date))))
        : is_snow ? kWinter
                  : kSummer;
    // South of the equator the months are the other way round.
    day.declination_deg = usual * (day.latitude_deg < 0 ? -1 : 1);
    return day;
}

// The circle of confusion of a thin lens, f² / (N (s − f)) at infinity, on the sensor.
double blur_of(const PhotoSettings& settings, double focus_m, double aspect) {
    if (settings.f_number <= 0) return 0;
    constexpr double kMillimetres = 1000;
    const double focal = settings.focal_mm, focus = std::max(kMillimetres * focus_m / kModelScale, 2 * focal);
    const double radius = focal * focal / (settings.f_number * (focus - focal)) / 2;
    return radius * aspect / kSensorWidth;
}

// The spherical triangle of pole, zenith and sun, as in Meeus (1998), formulas 13.5 and 13.6.
render::Light light_at(double hour, const PhotoDay& day) {
    const double turned = glm::radians(kDegreesPerHour * (hour - 12)),
                 latitude = glm::radians(day.latitude_deg), declination = glm::radians(day.declination_deg);
    const double height = std::sin(latitude) * std::sin(declination) +
                          std::cos(latitude) * std::cos(declination) * std::cos(turned);
    const double from_south = std::atan2(
        std::sin(turned), std::cos(turned) * std::sin(latitude) - std::tan(declination) * std::cos(latitude));
    return {std::fmod(glm::degrees(from_south) + 180 + 360, 360.0),
            std::clamp(glm::degrees(std::asin(std::clamp(height, -1.0, 1.0))), render::kLowestSunDeg,
                       render::kHighestSunDeg)};
}

double hour_like(const render::Light& light, const PhotoDay& day) {
    constexpr int kPerHour = 4;
    double best = 12, most = -2;
    for (int i = 0; i < 24 * kPerHour; ++i) {
        const double hour = static_cast<double>(i) / kPerHour,
                     likeness = glm::dot(direction_to(light), direction_to(light_at(hour, day)));
        if (likeness > most) most = likeness, best = hour;
    }
    return best;
}

}  // namespace game
