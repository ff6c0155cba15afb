#pragma once

#include <optional>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "game/controls/camera_path.h"
#include "game/controls/camera_room.h"
#include "render/camera.h"
#include "sim/world/state.h"

namespace game {

enum class CameraMode { kOrbit, kFly, kTopDown };

// What hands ask of the camera in one frame. Picture coordinates run from −1 (left, bottom) to 1.
struct CameraWish {
    // A drag, from where to where in this frame; `pivot` is the ground under the place where it began.
    enum class Drag { kNone, kTurn, kPan } drag = Drag::kNone;
    glm::dvec2 from{0}, to{0};
    double zoom_steps = 0;            // of the wheel; forward is nearer
    std::optional<glm::dvec3> pivot;  // m; what turning, panning and zooming hold on to; nothing over the sky
    glm::dvec3 walk{0};               // held keys: right, forward, up, each −1 to 1
    bool fast = false;                // four times as fast
};

// Moves a camera as hands ask. A view: it never changes the world.
//   turn   about the pivot, which stays where it is in the picture; half a turn per width of the picture; the
//          elevation stays within 3° to 89°. Flying, it looks around instead. From the top nothing turns:
//          north is up.
//   pan    the pivot stays under the cursor, at the height of the eye where the ray allows it.
//   zoom   a step takes 15 % off the way to the pivot, which stays where it is in the picture; from two cells
//          away to six diagonals of the grid.
//   walk   along the ground (flying: along the view), about half as far in a second as what it looks at is
//   away.
// What is asked is reached smoothly, within a few tenths of a second, on the same path at any frame rate. The
// eye stays a cell above the surface: where the ground is in the way a turn rises, a zoom stops, a pan backs
// off.
class CameraControl {
  public:
    // `home` is where overview() goes back to.
    CameraControl(const render::Camera& home, const sim::View& world);

    const render::Camera& camera() const { return now_; }
    CameraMode mode() const { return mode_; }
    bool still() const;  // has arrived: the camera stays the same until asked again

    void fly(bool on);  // leaves the view from the top
    // On: straight down on what was in the middle of the picture, as much of it to be seen, north up; from
    // the next move() on. Off: back to where it stood before.
    void top_down(bool on);
    void overview();  // in orbit

    // `aspect` is the picture's width / height. Of a frame that took longer than a quarter of a second the
    // keys count for that long.
    void move(const CameraWish& wish, const sim::View& world, double aspect, double elapsed_s);

  private:
    void look_down(const CameraRoom& room);
    void take_hold(const CameraWish& wish, double aspect, const CameraRoom& room);
    void zoom(double steps, const CameraRoom& room);
    void turn(glm::dvec2 by, double aspect, const CameraRoom& room);
    void pan(const CameraWish& wish, glm::dvec2 to, double aspect, const CameraRoom& room);
    void walk(const CameraWish& wish, double seconds, const CameraRoom& room);
    void approach(double seconds, const CameraRoom& room);

    render::Camera home_, now_, goal_, before_top_down_;
    CameraMode mode_ = CameraMode::kOrbit, mode_before_top_down_ = CameraMode::kOrbit;
    Grip hold_;                                            // what the way to the goal goes about
    CameraWish::Drag dragging_ = CameraWish::Drag::kNone;  // in the frame before
    bool look_down_ = false;  // asked, and move() has yet to see the ground for it
};

}  // namespace game
