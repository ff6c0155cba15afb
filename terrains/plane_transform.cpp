#include "terrains/plane_transform.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <string>

#include <fmt/format.h>
#include <ogr_srs_api.h>

#include "sim/core/check.h"
#include "terrains/gdal_support.h"

namespace terrains {

void PlaneTransform::destroy(void* transform) {
    OCTDestroyCoordinateTransformation(transform);
}

tl::expected<PlaneTransform, std::string> PlaneTransform::between(const std::string& from_wkt,
                                                                  const std::string& to_wkt) {
    const GdalErrors errors;
    const SpatialReference from = SpatialReference::from_wkt(from_wkt),
                           to = SpatialReference::from_wkt(to_wkt);
    if (!from || !to)
        return tl::unexpected(fmt::format("the coordinate system cannot be read ({})", errors.first()));
    void* transform = OCTNewCoordinateTransformation(from.get(), to.get());
    if (transform == nullptr)
        return tl::unexpected(
            fmt::format("its coordinate system cannot be transformed to the terrain's ({})", errors.first()));
    return PlaneTransform(transform);
}

bool PlaneTransform::apply(std::span<double> x, std::span<double> y) const {
    CHECK(x.size() == y.size());
    const GdalErrors errors;    // suppresses PROJ's message for each point; the return value suffices
    std::array<int, 512> done;  // processed in pieces, so that a single point allocates nothing
    bool all = true;
    for (std::size_t first = 0; first < x.size(); first += done.size()) {
        const std::size_t count = std::min(done.size(), x.size() - first);
        done.fill(0);
        OCTTransformEx(transform_.get(), static_cast<int>(count), &x[first], &y[first], nullptr, done.data());
        for (std::size_t i = 0; i < count; ++i) {
            double &px = x[first + i], &py = y[first + i];
            if (done[i] != 0 && std::isfinite(px) && std::isfinite(py)) continue;
            px = py = std::numeric_limits<double>::quiet_NaN();
            all = false;
        }
    }
    return all;
}

}  // namespace terrains
