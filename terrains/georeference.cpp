#include "terrains/georeference.h"

#include <cmath>
#include <string>
#include <utility>

#include <fmt/format.h>
#include <GeographicLib/Constants.hpp>
#include <GeographicLib/MGRS.hpp>
#include <GeographicLib/TransverseMercator.hpp>
#include <GeographicLib/UTMUPS.hpp>

#include "terrains/plane_transform.h"

namespace terrains {
namespace {

constexpr const char* kNotPlaced = "the terrain states no coordinate system, so it has no place on Earth";

// The plane of the kind "local": scale 1 at the meridian through its centre.
const GeographicLib::TransverseMercator& local_plane() {
    static const GeographicLib::TransverseMercator plane(GeographicLib::Constants::WGS84_a(),
                                                         GeographicLib::Constants::WGS84_f(), 1.0);
    return plane;
}

// Where the plane's centre lies along its meridian: GeographicLib measures northing from the equator.
double northing_of(LatLon centre) {
    double x = 0, y = 0;
    local_plane().Forward(centre.longitude, centre.latitude, centre.longitude, x, y);
    return y;
}

bool on_earth(LatLon p) {
    return std::abs(p.latitude) <= 90 && std::abs(p.longitude) <= 360;  // false for NaN
}

std::string format_degrees(LatLon p) {
    return fmt::format("{:.5f}° {} {:.5f}° {}", std::abs(p.latitude), p.latitude < 0 ? 'S' : 'N',
                       std::abs(p.longitude), p.longitude < 0 ? 'W' : 'E');
}

}  // namespace

Georeference Georeference::unnamed(double origin_x, double origin_y) {
    Georeference made;
    made.kind_ = Kind::kUnnamed;
    made.origin_x_ = origin_x;
    made.origin_y_ = origin_y;
    return made;
}

Georeference Georeference::projected(std::string wkt, double easting, double northing) {
    Georeference made = unnamed(easting, northing);
    made.kind_ = Kind::kProjected;
    made.wkt_ = std::move(wkt);
    return made;
}

Georeference Georeference::local(LatLon centre, double false_x, double false_y) {
    Georeference made = unnamed(false_x, false_y);
    made.kind_ = Kind::kLocal;
    made.wkt_ = local_plane_wkt(centre.latitude, centre.longitude);
    made.centre_ = centre;
    return made;
}

tl::expected<LatLon, std::string> Georeference::to_lat_lon(LocalPoint p) const {
    if (!placed()) return tl::unexpected<std::string>(kNotPlaced);
    LatLon there;
    double x = origin_x_ + p.x, y = origin_y_ + p.y;
    if (kind_ == Kind::kLocal) {
        local_plane().Reverse(centre_.longitude, x, y + northing_of(centre_), there.latitude,
                              there.longitude);
    } else {
        const auto transform = PlaneTransform::between(wkt_, wgs84_wkt());
        if (!transform) return tl::unexpected(transform.error());
        transform->apply({&x, 1}, {&y, 1});
        there = {y, x};
    }
    if (!on_earth(there))
        return tl::unexpected(
            fmt::format("the point {} m, {} m of the grid has no place on Earth", p.x, p.y));
    return there;
}

tl::expected<LocalPoint, std::string> Georeference::to_local(LatLon p) const {
    if (!placed()) return tl::unexpected<std::string>(kNotPlaced);
    double x = p.longitude, y = p.latitude;
    if (!on_earth(p))
        return tl::unexpected(fmt::format("{}, {} is not a latitude and longitude", p.latitude, p.longitude));
    if (kind_ == Kind::kLocal) {
        local_plane().Forward(centre_.longitude, p.latitude, p.longitude, x, y);
        y -= northing_of(centre_);
    } else {
        const auto transform = PlaneTransform::between(wgs84_wkt(), wkt_);
        if (!transform) return tl::unexpected(transform.error());
        transform->apply({&x, 1}, {&y, 1});
    }
    if (!std::isfinite(x) || !std::isfinite(y))
        return tl::unexpected(
            fmt::format("{} cannot be expressed in the terrain's coordinate system", format_degrees(p)));
    return LocalPoint{x - origin_x_, y - origin_y_};
}

std::string Georeference::describe(LocalPoint p) const {
    const auto there = to_lat_lon(p);
    if (!there) return {};
    try {
        int zone = 0;
        bool north = true;
        double easting = 0, northing = 0;
        GeographicLib::UTMUPS::Forward(there->latitude, there->longitude, zone, north, easting, northing);
        std::string zone_and_band;  // precision −1 is "grid zone only": 32T, or Z at the pole
        GeographicLib::MGRS::Forward(zone, north, easting, northing, there->latitude, -1, zone_and_band);
        return fmt::format("{}, {} {} {:.0f} {:.0f}", format_degrees(*there), zone == 0 ? "UPS" : "UTM",
                           zone_and_band, easting, northing);
    } catch (const GeographicLib::GeographicErr&) {
        return format_degrees(*there);  // off the grid of zones: degrees still say where
    }
}

}  // namespace terrains
