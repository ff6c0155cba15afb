#pragma once

#include <optional>
#include <span>

#include "terrains/georeference.h"
#include "terrains/plane_transform.h"

namespace terrains {

// Says where points are on Earth, one after the other, without preparing the coordinate system anew each time
// as Georeference does. Move-only.
class Locator {
  public:
    explicit Locator(const Georeference& georeference);

    // Georeference::describe(p), cut to `text` and closed with 0; empty where not placed or not expressible.
    // Does not allocate on our side.
    void describe(LocalPoint p, std::span<char> text) const;
};

}  // namespace terrains
