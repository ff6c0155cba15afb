#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "game/scene/camera_key.h"

namespace game {

// A camera that moves along the keys of a path. Each of its values is a monotone cubic of time [fritsch1984]: continuous
// with its first derivative, never beyond the two keys beside it, and at rest at both ends, before which and after which
// the camera stands. Azimuths go the short way; distances and fields of view change by equal shares.
// It knows no ground: CameraRoom::inside() raises what it returns.
class CameraSpline {
  public:
    // At times that increase strictly; one key at least.
    explicit CameraSpline(std::span<const CameraKey> keys);

    render::Camera at(double time_s) const;
    double begins_s() const { return knots_.front().time_s; }
    double ends_s() const { return knots_.back().time_s; }

  private:
    // East, north and height of the target; azimuth, elevation; logarithms of distance and field of view.
    using Values = std::array<double, 7>;
    struct Knot {
        double time_s;
        Values value, slope;  // slope per s
    };
    static Values values_of(const render::Camera& camera);
    static render::Camera camera_of(const Values& values);

    std::vector<Knot> knots_;
};

}  // namespace game
