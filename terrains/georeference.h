#pragma once

#include <string>

#include <tl/expected.hpp>

namespace terrains {

struct LatLon {
    double latitude = 0, longitude = 0;  // WGS 84, degrees; north and east positive
};

bool on_earth(LatLon p);  // whether it is a latitude and a longitude; false for NaN

struct LocalPoint {
    double x = 0, y = 0;  // m from the grid's south-west vertex, along the grid's own axes
};

// The position of a grid on Earth, with conversions both ways. Four kinds:
//   not placed: a generated terrain, local metres only.
//   unnamed: a DEM without a coordinate system. Its coordinates are kept, so that rasters of one set align,
//     but their place on Earth is unknown; not placed either.
//   projected: the DEM's own metric coordinate system. The grid keeps its axes,
//     x = easting − easting of vertex (0, 0).
//   local: a DEM in degrees, or in a system whose metres are not true there, projected to a transverse
//     Mercator plane through its own centre (local_plane.h), so that lengths and angles are true and y is
//     north.
// A value: cheap to copy, holds no library handle. For many points at once use PlaneTransform with wkt().
class Georeference {
  public:
    Georeference() = default;  // not placed

    // Coordinates of vertex (0, 0) in metres of an unnamed system.
    static Georeference unnamed(double origin_x, double origin_y);

    // `wkt` is a coordinate system with metres as its unit; easting and northing are those of vertex (0, 0).
    static Georeference projected(std::string wkt, double easting, double northing);

    // Plane through `centre`; vertex (0, 0) is at (false_x, false_y) from it, m.
    static Georeference local(LatLon centre, double false_x, double false_y);

    bool is_local() const { return kind_ == Kind::kLocal; }
    bool placed() const { return kind_ == Kind::kProjected || kind_ == Kind::kLocal; }
    // Whether origin_x and origin_y mean something to other files: every kind but "not placed".
    bool has_coordinates() const { return kind_ != Kind::kNone; }

    // Centre of the local plane; meaningless for other kinds.
    LatLon centre() const { return centre_; }

    // Fails if not placed, or if the coordinate system cannot express the point.
    tl::expected<LatLon, std::string> to_lat_lon(LocalPoint p) const;
    tl::expected<LocalPoint, std::string> to_local(LatLon p) const;

    // WKT of the plane the grid lies on, for exports; empty if not placed.
    const std::string& wkt() const { return wkt_; }
    // Coordinates of vertex (0, 0) in that plane, m.
    double origin_x() const { return origin_x_; }
    double origin_y() const { return origin_y_; }

    // "47.30012° N 11.43210° E, UTM 32T 683912 5240010"; empty if not placed or not expressible. Beyond
    // 84° N and 80° S the second half is the polar grid, "UPS Z 2000000 2000000".
    std::string describe(LocalPoint p) const;

  private:
    enum class Kind { kNone, kUnnamed, kProjected, kLocal };
    Kind kind_ = Kind::kNone;
    std::string wkt_;
    LatLon centre_;
    double origin_x_ = 0, origin_y_ = 0;
};

}  // namespace terrains
