#pragma once

#include <optional>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "render/camera.h"
#include "sim/state.h"

namespace game {

enum class CameraMode { kOrbit, kFly, kTopDown };

// What hands ask of the camera in one frame. Picture coordinates run from −1 (left, bottom) to 1.
struct CameraWish {
    // A drag, from where to where; `pivot` is the ground under the place where it began.
    enum class Drag { kNone, kTurn, kPan } drag = Drag::kNone;
    glm::dvec2 from{0}, to{0};
    double zoom_steps = 0;              // of the wheel; forward is nearer
    std::optional<glm::dvec3> pivot;    // m; what turning, panning and zooming hold on to
    glm::dvec3 walk{0};                 // held keys: right, forward, up, each −1 to 1
    bool fast = false;                  // four times as fast
};

// Moves a camera as hands ask: turning, panning and zooming hold the ground under the cursor where it is on the
// screen. What is asked is reached smoothly, within a few tenths of a second, on the same path at any frame rate. A view: it
// never changes the world.
class CameraControl {
  public:
    // `home` is where overview() goes back to.
    CameraControl(const render::Camera& home, const sim::View& world);

    const render::Camera& camera() const { return now_; }
    CameraMode mode() const { return mode_; }
    bool still() const;  // has arrived

    void fly(bool on);
    void top_down(bool on);  // off: back to where it stood before
    void overview();

    // `aspect` is the picture's width / height.
    void move(const CameraWish& wish, const sim::View& world, double aspect, double elapsed_s);

  private:
    render::Camera home_, now_, goal_, before_top_down_;
    CameraMode mode_ = CameraMode::kOrbit;
};

}  // namespace game
