#pragma once

#include <optional>
#include <span>

#include "terrains/georeference.h"
#include "terrains/plane_transform.h"

namespace terrains {

// Describes the positions of successive points on Earth. Unlike Georeference, it prepares the coordinate
// system only once. Move-only; not to be shared between threads.
class Locator {
  public:
    explicit Locator(const Georeference& georeference);

    // Writes Georeference::describe(p), truncated to fit `text` and null-terminated; empty if not placed or
    // not expressible. Does not allocate, unless PROJ or GeographicLib refuses the point.
    void describe(LocalPoint p, std::span<char> text) const;

  private:
    std::optional<LatLon> lat_lon(LocalPoint p) const;  // NaN if not expressible

    std::optional<PlaneTransform> to_degrees_;  // of projected kinds
    std::optional<LatLon> centre_;              // of the local kind
    LocalPoint origin_;                         // coordinates of vertex (0, 0), m
};

}  // namespace terrains
