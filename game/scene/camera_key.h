#pragma once

#include "render/view/camera.h"

namespace game {

// A key of a camera path: a camera at a time of the world. Between keys it moves smoothly (controls/camera_spline.h).
struct CameraKey {
    static constexpr double kLatest = 1e5;  // s

    double time_s = 0;  // of the world, 0 to kLatest
    render::Camera camera;
    bool operator==(const CameraKey&) const = default;
};

inline constexpr double kFarthestTarget = 1e9;  // m, of each coordinate of a camera's target

}  // namespace game
