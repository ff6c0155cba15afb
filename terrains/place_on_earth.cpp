#include <array>
#include <cmath>

#include <fmt/format.h>

#include "terrains/georeference.h"
#include "terrains/local_plane.h"
#include "terrains/locator.h"
#include "terrains/plane_transform.h"
#include "terrains/well_known_text.h"

// Conversions between a grid and the Earth, which need PROJ; a georeference is a value without them.

namespace terrains {
namespace {

constexpr const char* kNotPlaced =
    "the terrain has no coordinate system, so its position on Earth is unknown";

}  // namespace

tl::expected<LatLon, std::string> Georeference::to_lat_lon(LocalPoint p) const {
    if (!placed()) return tl::unexpected<std::string>(kNotPlaced);
    LatLon there;
    double x = origin_x_ + p.x, y = origin_y_ + p.y;
    if (kind_ == Kind::kLocal) {
        there = from_local_plane(centre_, {x, y});
    } else {
        const auto transform = PlaneTransform::between(wkt_, wgs84_wkt());
        if (!transform) return tl::unexpected(transform.error());
        transform->apply({&x, 1}, {&y, 1});
        there = {y, x};
    }
    if (!on_earth(there))
        return tl::unexpected(
            fmt::format("the point {} m, {} m of the grid has no position on Earth", p.x, p.y));
    return there;
}

tl::expected<LocalPoint, std::string> Georeference::to_local(LatLon p) const {
    if (!placed()) return tl::unexpected<std::string>(kNotPlaced);
    if (!on_earth(p))
        return tl::unexpected(fmt::format("{}, {} is not a latitude and longitude", p.latitude, p.longitude));
    double x = p.longitude, y = p.latitude;
    if (kind_ == Kind::kLocal) {
        const LocalPoint there = to_local_plane(centre_, p);
        x = there.x;
        y = there.y;
    } else {
        const auto transform = PlaneTransform::between(wgs84_wkt(), wkt_);
        if (!transform) return tl::unexpected(transform.error());
        transform->apply({&x, 1}, {&y, 1});
    }
    if (!std::isfinite(x) || !std::isfinite(y))
        return tl::unexpected(
            fmt::format("{:.5f}, {:.5f} cannot be expressed in the terrain's coordinate system", p.latitude,
                        p.longitude));
    return LocalPoint{x - origin_x_, y - origin_y_};
}

std::string Georeference::describe(LocalPoint p) const {
    std::array<char, 96> text;
    Locator(*this).describe(p, text);
    return text.data();
}

}  // namespace terrains
