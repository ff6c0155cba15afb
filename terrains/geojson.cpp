#include "terrains/geojson.h"

#include <cmath>
#include <fstream>
#include <string>
#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "files/input.h"
#include "terrains/json_reader.h"
#include "terrains/limits.h"
#include "terrains/plane_transform.h"
#include "terrains/well_known_text.h"

namespace terrains {
namespace {

using Json = nlohmann::json;
using Done = tl::expected<void, std::string>;

constexpr double kMostThickness = 100;  // m

tl::expected<Json, std::string> parse(const std::filesystem::path& path) {
    std::error_code status;
    const auto size = std::filesystem::file_size(path, status);
    if (status) return tl::unexpected(fmt::format("cannot be opened ({})", status.message()));
    if (size > kMostGeoJsonBytes)
        return tl::unexpected(fmt::format("over {} MiB, the limit for outlines", kMostGeoJsonBytes >> 20));
    std::ifstream file(path, std::ios::binary);
    std::string text(static_cast<std::size_t>(size), '\0');
    file.read(text.data(), static_cast<std::streamsize>(text.size()));
    if (!file) return tl::unexpected<std::string>("cannot be read");
    return read_json<Json>(text, kGeoJsonLimits);
}

// A member of an object, or null if it is missing.
const Json& member(const Json& object, const char* name) {
    static const Json none;
    if (!object.is_object()) return none;
    const auto found = object.find(name);
    return found == object.end() ? none : *found;
}

std::string text_of(const Json& value) {
    return value.is_string() ? value.get<std::string>() : std::string();
}

// Files older than RFC 7946 may name a coordinate system.
Done check_system(const Json& root) {
    const std::string name = text_of(member(member(member(root, "crs"), "properties"), "name"));
    for (const char* wgs84 : {"", "urn:ogc:def:crs:OGC:1.3:CRS84", "urn:ogc:def:crs:OGC::CRS84", "EPSG:4326",
                              "urn:ogc:def:crs:EPSG::4326"})
        if (name == wgs84) return {};
    return tl::unexpected(fmt::format("its coordinate system is {}; convert it to WGS 84 degrees", name));
}

// How thick a feature is.
struct Stated {
    double thickness = 0;  // m
    bool normal = false;
};

// Rings as in the file, x longitude and y latitude, until all are transformed to the plane at once.
struct Outlines {
    std::vector<double> x, y;
    std::vector<std::vector<std::size_t>> ring_sizes;  // per polygon
    std::vector<Stated> thickness;                     // per polygon
    std::size_t without_geometry = 0;                  // features
};

Done add_ring(const Json& ring, Outlines& outlines) {
    if (!ring.is_array() || ring.size() < 4)
        return tl::unexpected<std::string>("a ring has fewer than 4 points");
    if (outlines.x.size() + ring.size() > kMostGeoJsonPoints)
        return tl::unexpected(fmt::format("over {} points, the limit for outlines", kMostGeoJsonPoints));
    for (const Json& point : ring) {
        if (!point.is_array() || point.size() < 2 || !point[0].is_number() || !point[1].is_number())
            return tl::unexpected<std::string>("a point is not two numbers");
        const double longitude = point[0].get<double>(), latitude = point[1].get<double>();
        if (!(std::abs(longitude) <= 180 && std::abs(latitude) <= 90))
            return tl::unexpected(
                fmt::format("{}, {} is not a longitude and latitude in degrees", longitude, latitude));
        outlines.x.push_back(longitude);
        outlines.y.push_back(latitude);
    }
    outlines.ring_sizes.back().push_back(ring.size());
    return {};
}

Done add_polygon(const Json& rings, Stated thickness, Outlines& outlines) {
    if (!rings.is_array() || rings.empty()) return tl::unexpected<std::string>("a polygon has no rings");
    outlines.ring_sizes.emplace_back();
    outlines.thickness.push_back(thickness);
    for (const Json& ring : rings)
        if (auto added = add_ring(ring, outlines); !added) return added;
    return {};
}

Done add_geometry(const Json& geometry, Stated thickness, Outlines& outlines) {
    const std::string type = text_of(member(geometry, "type"));
    const Json& coordinates = member(geometry, "coordinates");
    if (type == "Polygon") return add_polygon(coordinates, thickness, outlines);
    if (type != "MultiPolygon")
        return tl::unexpected(fmt::format("its geometry is '{}'; it must be Polygon or MultiPolygon", type));
    if (!coordinates.is_array() || coordinates.empty())
        return tl::unexpected<std::string>("it has no polygons");
    for (const Json& polygon : coordinates)
        if (auto added = add_polygon(polygon, thickness, outlines); !added) return added;
    return {};
}

tl::expected<Stated, std::string> thickness_of(const Json& feature,
                                               const std::optional<ThicknessNames>& names) {
    if (!names) return Stated();
    const Json& properties = member(feature, "properties");
    const bool has_vertical = !member(properties, names->vertical.c_str()).is_null();
    const bool normal = !member(properties, names->normal.c_str()).is_null();
    if (has_vertical == normal)
        return tl::unexpected(
            fmt::format("it has {} '{}' (vertical metres) {} '{}' (metres normal to the slope)",
                        normal ? "both" : "neither", names->vertical, normal ? "and" : "nor", names->normal));
    const std::string& name = normal ? names->normal : names->vertical;
    const Json& stated = member(properties, name.c_str());
    if (!stated.is_number()) return tl::unexpected(fmt::format("its '{}' is not a number", name));
    const double thickness = stated.get<double>();
    if (!(thickness > 0 && thickness <= kMostThickness))
        return tl::unexpected(fmt::format("its '{}' is {} m; it must be above 0 and at most {} m", name,
                                          thickness, kMostThickness));
    return Stated{thickness, normal || names->both_normal};
}

Done add_feature(const Json& feature, const std::optional<ThicknessNames>& names, Outlines& outlines) {
    const bool bare = text_of(member(feature, "type")) != "Feature";
    if (!bare && (!feature.contains("geometry"))) return tl::unexpected<std::string>("it has no geometry");
    if (!bare && feature["geometry"].is_null()) {
        ++outlines.without_geometry;
        return {};
    }
    const auto thickness = thickness_of(feature, names);
    if (!thickness) return tl::unexpected(thickness.error());
    return add_geometry(bare ? feature : member(feature, "geometry"), *thickness, outlines);
}

tl::expected<Outlines, std::string> collect(const Json& root, const std::optional<ThicknessNames>& names) {
    if (auto right = check_system(root); !right) return tl::unexpected(right.error());
    Outlines outlines;
    if (text_of(member(root, "type")) != "FeatureCollection") {
        if (auto added = add_feature(root, names, outlines); !added) return tl::unexpected(added.error());
        if (outlines.x.empty()) return tl::unexpected<std::string>("its feature has no geometry");
        return outlines;
    }
    const Json& features = member(root, "features");
    if (!features.is_array() || features.empty()) return tl::unexpected<std::string>("it has no features");
    for (std::size_t i = 0; i < features.size(); ++i)
        if (auto added = add_feature(features[i], names, outlines); !added)
            return tl::unexpected(fmt::format("feature {}: {}", i + 1, added.error()));
    if (outlines.x.empty()) return tl::unexpected<std::string>("none of its features has a geometry");
    return outlines;
}

tl::expected<Areas, std::string> on_plane(Outlines outlines, const Georeference& georeference) {
    if (!georeference.placed())
        return tl::unexpected<std::string>(
            "it is in degrees, but the terrain has no coordinate system, so they cannot be aligned");
    const auto transform = PlaneTransform::between(wgs84_wkt(), georeference.wkt());
    if (!transform) return tl::unexpected(transform.error());
    if (!transform->apply(outlines.x, outlines.y))
        return tl::unexpected<std::string>(
            "it has points that the terrain's coordinate system cannot express");
    Areas result{{}, outlines.without_geometry};
    std::vector<Area>& areas = result.areas;
    areas.reserve(outlines.ring_sizes.size());
    std::size_t next = 0;
    for (std::size_t polygon = 0; polygon < outlines.ring_sizes.size(); ++polygon) {
        areas.push_back({{}, outlines.thickness[polygon].thickness, outlines.thickness[polygon].normal});
        for (const std::size_t size : outlines.ring_sizes[polygon]) {
            auto& ring = areas.back().rings.emplace_back();
            for (const std::size_t end = next + size; next < end; ++next)
                ring.push_back(
                    {outlines.x[next] - georeference.origin_x(), outlines.y[next] - georeference.origin_y()});
        }
    }
    return result;
}

}  // namespace

bool looks_like_json(const std::filesystem::path& path) {
    auto opened = files::open_input(path);  // not a pipe, which might never begin
    if (!opened) return false;
    std::ifstream& file = *opened;
    if (file.peek() == 0xEF) file.ignore(3);  // a byte order mark
    char first = 0;
    file >> std::ws >> first;
    return first == '{';
}

tl::expected<Areas, std::string> read_areas(const std::filesystem::path& path,
                                            const Georeference& georeference,
                                            const std::optional<ThicknessNames>& names) {
    if (auto is_file = files::check_input(path); !is_file) return tl::unexpected(is_file.error());
    auto areas =
        parse(path)
            .and_then([&](const Json& root) { return collect(root, names); })
            .and_then([&](Outlines outlines) { return on_plane(std::move(outlines), georeference); });
    if (!areas) return tl::unexpected(fmt::format("{}: {}", path.string(), areas.error()));
    return areas;
}

}  // namespace terrains
