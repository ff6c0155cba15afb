#pragma once

#include <glm/vec3.hpp>

#include "render/mountain/surroundings.h"
#include "render/view/camera.h"
#include "sim/world/state.h"

namespace game {

// The space allowed for a camera: at least one cell above the current surface and its surroundings, and not
// too far away. Valid as long as both.
class CameraRoom {
  public:
    CameraRoom(const sim::View& world, const render::Surroundings& around);

    double nearest() const { return 2 * cell_; }       // m, least distance from the eye to the zoom pivot
    double farthest() const { return 6 * diagonal_; }  // m, greatest distance
    double cell() const { return cell_; }              // m

    // Whether a point is near enough for the coordinates to keep their precision.
    bool reaches(glm::dvec3 point) const;
    // m; outside the grid above the surroundings or, without them, above the nearest border.
    double height_above_ground(const render::Camera& camera) const;
    // The camera raised and pulled back into the allowed space.
    render::Camera inside(render::Camera camera) const;

    // `pose(share)` at the least share from 0 to 1 at which the ground does not obstruct; pose(0) if it
    // always does.
    template <class Pose>
    render::Camera first_clear(const Pose& pose) const;

    // The ground at the image centre, on the grid; below the target if there is only sky.
    glm::dvec3 ground_in_the_middle(const render::Camera& camera) const;

  private:
    double ground_at(glm::dvec2 at) const;
    bool clear(const render::Camera& camera) const;

    const sim::View& world_;
    const render::Surroundings& around_;
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
