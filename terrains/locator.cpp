#include "terrains/locator.h"

#include <cmath>
#include <string>
#include <utility>

#include <fmt/format.h>
#include <GeographicLib/MGRS.hpp>
#include <GeographicLib/UTMUPS.hpp>

#include "terrains/local_plane.h"
#include "terrains/well_known_text.h"

namespace terrains {
namespace {

struct ZoneMetres {
    int zone = 0;  // 0 is the polar grid
    double easting = 0, northing = 0;
    std::string name;  // "32T", or "Z" at the pole; short enough to need no allocation
};

// Empty off the grid of zones.
std::optional<ZoneMetres> zone_metres(LatLon p) {
    try {
        ZoneMetres made;
        bool north = true;
        GeographicLib::UTMUPS::Forward(p.latitude, p.longitude, made.zone, north, made.easting,
                                       made.northing);
        constexpr int kNameOnly = -1;
        GeographicLib::MGRS::Forward(made.zone, north, made.easting, made.northing, p.latitude, kNameOnly,
                                     made.name);
        return made;
    } catch (const GeographicLib::GeographicErr&) {
        return std::nullopt;
    }
}

template <class... Values>
void write(std::span<char> text, fmt::format_string<Values...> form, Values&&... values) {
    *fmt::format_to_n(text.data(), text.size() - 1, form, std::forward<Values>(values)...).out = '\0';
}

}  // namespace

Locator::Locator(const Georeference& georeference)
    : origin_{georeference.origin_x(), georeference.origin_y()} {
    if (!georeference.placed()) return;
    if (georeference.is_local()) {
        centre_ = georeference.centre();
    } else if (auto transform = PlaneTransform::between(georeference.wkt(), wgs84_wkt())) {
        to_degrees_ = std::move(*transform);
    }
}

std::optional<LatLon> Locator::lat_lon(LocalPoint p) const {
    double x = origin_.x + p.x, y = origin_.y + p.y;
    if (centre_) return from_local_plane(*centre_, {x, y});
    if (!to_degrees_) return std::nullopt;
    to_degrees_->apply({&x, 1}, {&y, 1});
    return LatLon{y, x};
}

void Locator::describe(LocalPoint p, std::span<char> text) const {
    if (text.empty()) return;
    text.front() = '\0';
    const auto there = lat_lon(p);
    if (!there || !on_earth(*there)) return;
    const double north = std::abs(there->latitude), east = std::abs(there->longitude);
    const char half = there->latitude < 0 ? 'S' : 'N', side = there->longitude < 0 ? 'W' : 'E';
    // Off the grid of zones, degrees still give the position.
    if (const auto metres = zone_metres(*there))
        write(text, "{:.5f}° {} {:.5f}° {}, {} {} {:.0f} {:.0f}", north, half, east, side,
              metres->zone == 0 ? "UPS" : "UTM", metres->name, metres->easting, metres->northing);
    else
        write(text, "{:.5f}° {} {:.5f}° {}", north, half, east, side);
}

}  // namespace terrains
