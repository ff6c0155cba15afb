#include "game/scene/scene_light.h"

#include <algorithm>
#include <cmath>

#include <glm/trigonometric.hpp>

#include "game/scene/shown_numbers.h"
#include "render/view/sky_light.h"
#include "render/view/sun_position.h"

namespace game {
namespace {

// The direction of the grid's y axis at a point, degrees from north, east positive. 0 if not placed.
double grid_north(const terrains::Georeference& georeference, terrains::LocalPoint at) {
    constexpr double kStep = 1000;  // m
    const auto here = georeference.to_lat_lon(at), ahead = georeference.to_lat_lon({at.x, at.y + kStep});
    if (!here || !ahead) return 0;
    const double east =
        std::remainder(ahead->longitude - here->longitude, 360) * std::cos(glm::radians(here->latitude));
    return glm::degrees(std::atan2(east, ahead->latitude - here->latitude));
}

}  // namespace

std::optional<SunMoment> read_light(TomlTable& table, render::Light& light) {
    table.numbers(kLightNumbers, light);
    const auto latitude = table.number("latitude", -90, 90);
    const auto longitude = table.number("longitude", -180, 180);
    const auto time = table.moment("time", 1900, 2100);
    const bool has_time = table.has("time");
    table.finish();

    if (has_time && (table.has("azimuth") || table.has("elevation")))
        table.blame(table.has("azimuth") ? "azimuth" : "elevation",
                    "is given beside light.time, from which it follows; leave out one of them");
    if (!has_time && (latitude || longitude))
        table.blame(latitude ? "latitude" : "longitude",
                    "is given without light.time; add a time, such as 2026-02-14T08:30:00+01:00");
    if (table.has("latitude") != table.has("longitude"))
        table.blame(latitude ? "latitude" : "longitude", "needs both light.latitude and light.longitude");
    if (!time) return std::nullopt;
    SunMoment moment{*time, {}};
    if (latitude && longitude) moment.place = {*latitude, *longitude};
    return moment;
}

bool set_sun(const SunMoment& moment, Scenario& scenario) {
    const sim::Grid& grid = scenario.grid;
    const terrains::LocalPoint middle{0.5 * (grid.nx - 1) * static_cast<double>(grid.dx),
                                      0.5 * (grid.ny - 1) * static_cast<double>(grid.dx)};
    auto place = moment.place;
    if (!place)
        if (const auto known = scenario.georeference.to_lat_lon(middle)) place = *known;
    if (!place) return false;
    const render::Light sun = render::sun_position(place->latitude, place->longitude, moment.unix_s);
    const double azimuth = sun.azimuth_deg - grid_north(scenario.georeference, middle);
    scenario.light = {azimuth - 360 * std::floor(azimuth / 360),
                      std::clamp(sun.elevation_deg, render::kLowestSunDeg, render::kHighestSunDeg)};
    return true;
}

}  // namespace game
