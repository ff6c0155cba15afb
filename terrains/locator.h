#pragma once

#include <optional>
#include <span>

#include "terrains/georeference.h"
#include "terrains/plane_transform.h"

namespace terrains {

// Says where points are on Earth, one after the other, without preparing the coordinate system anew each time
// as Georeference does. Move-only; not to be shared between threads.
class Locator {
  public:
    explicit Locator(const Georeference& georeference);

    // Georeference::describe(p), cut to `text` and closed with 0; empty where not placed or not expressible.
    // Does not allocate, unless PROJ or GeographicLib refuses the point.
    void describe(LocalPoint p, std::span<char> text) const;

  private:
    std::optional<LatLon> lat_lon(LocalPoint p) const;  // NaN where not expressible

    std::optional<PlaneTransform> to_degrees_;  // of projected kinds
    std::optional<LatLon> centre_;              // of the local kind
    LocalPoint origin_;                         // coordinates of vertex (0, 0), m
};

}  // namespace terrains
