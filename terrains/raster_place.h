#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include <tl/expected.hpp>

#include "terrains/gdal_support.h"
#include "terrains/georeference.h"
#include "terrains/plane_transform.h"

namespace terrains {

// The positions of a raster's pixels on the terrain's plane; read_dem() describes the choice of that plane.
// Include from sources only: GDAL's types are in it.
class RasterPlace {
  public:
    // Errors: no geotransform, degrees over more than 2° (other warped systems: 250 km), pixels off the
    // Earth, a .prj that cannot be read, a raster that seems to be in degrees but names no coordinate system, a rotated raster without
    // one, pixels or coordinates of an impossible size.
    static tl::expected<RasterPlace, std::string> of_dem(const Raster& raster);

    // Plane coordinates of the pixel centres of one row, m; NaN if the plane cannot express them. On a warped
    // raster every eighth is exact and the others are interpolated linearly: under 2 mm off for pixels up to
    // 30 m.
    void positions(int row, std::vector<double>& x, std::vector<double>& y) const;

    // Exact plane coordinates of any positions in one row, in pixels from the centre of the first pixel.
    void places(const std::vector<double>& columns, double row, std::vector<double>& x,
                std::vector<double>& y) const;

    Georeference georeference;                          // its origin is (min_x, min_y)
    double min_x = 0, min_y = 0, max_x = 0, max_y = 0;  // m, plane coordinates of the terrain's rectangle
    double reach_x = 0, reach_y = 0;                    // m between neighbouring pixels, as PlaneFit wants it
    double pixel_area = 0;                              // m²

  private:
    tl::expected<void, std::string> keep_axes();
    tl::expected<void, std::string> lay_on_local_plane(const std::string& wkt);
    tl::expected<void, std::string> check_lengths() const;
    void measure_rectangle();
    void measure_pixels();
    bool rotated() const { return geotransform_[2] != 0 || geotransform_[4] != 0; }
    bool project(std::vector<double>& x, std::vector<double>& y) const;
    void centres(const std::vector<double>& columns, const std::vector<double>& rows, std::vector<double>& x,
                 std::vector<double>& y) const;

    int columns_ = 0, rows_ = 0;
    std::array<double, 6> geotransform_{};
    std::optional<PlaneTransform> warp_;  // from the raster's system to the plane, if they differ
};

// A grid in a metric system given as a code or WKT (read_system()), with vertex (0, 0) at x, y. Errors: those of
// set_system(), which are checked at (middle_x, middle_y).
tl::expected<Georeference, std::string> place_in(const std::string& system, double x, double y,
                                                 double middle_x, double middle_y);

}  // namespace terrains
