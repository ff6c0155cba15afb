#pragma once

#include <optional>
#include <utility>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "game/controls/camera_control.h"
#include "game/controls/display.h"
#include "game/controls/input.h"
#include "game/controls/screen.h"
#include "game/scene/mountains.h"
#include "render/mountain/pick.h"

namespace game {

// Where the user looks from: the camera, the mountains and woods around the world that it sees, and what is under the
// cursor. A point of the image runs from −1 (left, bottom) to 1. The world may differ from call to call, its grid not,
// until enter() is called again. Surroundings are as displayed.
class Lookout {
  public:
    // Both outlive it.
    Lookout(const Screen& screen, const Display& display) : screen_(screen), display_(display) {}

    void surround(Backdrop backdrop) { backdrop_ = std::move(backdrop); }
    // A camera for this world, in the middle of what surrounds it.
    void enter(const render::Camera& home, const sim::View& world) {
        control_.emplace(home, world, surroundings());
    }
    const CameraControl& control() const { return *control_; }
    CameraControl& control() { return *control_; }
    const render::Camera& camera() const { return control_->camera(); }
    const render::Surroundings& surroundings() const;
    const render::Land& land() const { return backdrop_.land; }
    const render::Woods& woods() const { return backdrop_.woods; }

    // Applies the input of a frame to the camera, and finds the ground under the cursor in the new view.
    void move(const Input& input, const std::optional<SlideFront::Front>& followed, const sim::View& world,
              double elapsed_s);
    const std::optional<glm::dvec3>& ground() const { return ground_; }
    double aspect() const;  // of the image, width / height

    // Nothing if sky or a mountain is there.
    std::optional<glm::dvec3> ground_under(glm::dvec2 point, const sim::View& world) const;
    bool mountain_under(glm::dvec2 point, const sim::View& world) const;
    // The same, but a place on a mountain if one is there; nothing for sky alone.
    std::optional<glm::dvec3> land_under(glm::dvec2 point, const sim::View& world) const;

    // Px from the top left; nothing behind the camera.
    std::optional<glm::dvec2> on_screen(glm::dvec3 place) const;
    // The same for a place on the ground; nothing either if other ground or a mountain hides it.
    std::optional<glm::dvec2> seen_on_screen(glm::dvec2 place, const sim::View& world) const;

  private:
    render::Ray ray_under(glm::dvec2 point) const;
    // m along the ray to the mountains around the grid.
    std::optional<double> mountain_along(render::Ray ray, const sim::View& world) const;

    const Screen& screen_;
    const Display& display_;
    Backdrop backdrop_;
    std::optional<CameraControl> control_;
    std::optional<glm::dvec3> pivot_;   // of a drag, or of turning without one
    bool turns_ = false;                // without a drag, in the last frame
    std::optional<glm::dvec3> ground_;  // under the cursor
};

}  // namespace game
