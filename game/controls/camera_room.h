#pragma once

#include <glm/vec3.hpp>

#include "render/camera.h"
#include "sim/world/state.h"

namespace game {

// Where a camera may be: a cell above the surface, as deep as it lies now, and not lost in the distance.
// Valid as long as the view.
class CameraRoom {
  public:
    explicit CameraRoom(const sim::View& world);

    double nearest() const { return 2 * cell_; }       // m, from the eye to the ground that it zooms to
    double farthest() const { return 6 * diagonal_; }  // m, the same
    double cell() const { return cell_; }              // m

    // Whether a point is so near that metres still have their digits.
    bool reaches(glm::dvec3 point) const;
    // m; beside the grid above the nearest border.
    double height_above_ground(const render::Camera& camera) const;
    // Lifted, and pulled back, until it is in the room.
    render::Camera inside(render::Camera camera) const;

    // What `pose(share)` is at the least share of 0 to 1 at which the ground is not in its way; pose(0) where
    // it always is.
    template <class Pose>
    render::Camera first_clear(const Pose& pose) const;

    // The ground in the middle of the picture, on the grid; under the target where there is only sky.
    glm::dvec3 ground_in_the_middle(const render::Camera& camera) const;

  private:
    bool clear(const render::Camera& camera) const;

    const sim::View& world_;
    double cell_, diagonal_;  // m
    glm::dvec3 centre_;       // on the ground
};

template <class Pose>
render::Camera CameraRoom::first_clear(const Pose& pose) const {
    constexpr int kTries = 64, kHalvings = 20;
    if (clear(pose(0.0))) return pose(0.0);
    for (int i = 1; i <= kTries; ++i) {
        double blocked = (i - 1.0) / kTries, free = static_cast<double>(i) / kTries;
        if (!clear(pose(free))) continue;
        for (int j = 0; j < kHalvings; ++j) {
            const double middle = (blocked + free) / 2;
            (clear(pose(middle)) ? free : blocked) = middle;
        }
        return pose(free);
    }
    return pose(0.0);
}

}  // namespace game
