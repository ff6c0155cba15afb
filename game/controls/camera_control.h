#pragma once

#include <optional>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "game/controls/camera_path.h"
#include "game/controls/camera_room.h"
#include "game/controls/slide_front.h"
#include "render/view/camera.h"
#include "sim/world/state.h"

namespace game {

enum class CameraMode { kOrbit, kFly, kTopDown, kChase };

// Camera input of one frame. Image coordinates run from −1 (left, bottom) to 1.
struct CameraWish {
    // The drag in this frame; `pivot` is the ground under the point where it began.
    enum class Drag { kNone, kTurn, kPan } drag = Drag::kNone;
    glm::dvec2 from{0}, to{0};
    double zoom_steps = 0;            // of the wheel; forward is nearer
    std::optional<glm::dvec3> pivot;  // m; fixed by turn, pan and zoom; nothing over the sky
    glm::dvec3 walk{0};               // held keys: right, forward, up, each −1 to 1
    bool fast = false;                // four times as fast
    using Followed = SlideFront::Front;
    std::optional<Followed> followed;  // what chase mode follows; nothing: it waits
};

// Moves a camera by user input. It never changes the world.
//   turn   rotates about the pivot, which stays fixed in the image: 180° per image width, elevation 3° to 89°.
//          In fly mode it looks around instead. The top view does not turn: north is up.
//   pan    keeps the pivot under the cursor and the eye at its height if the ray allows it.
//   zoom   shortens the distance to the pivot by 15 % per step; the pivot stays fixed in the image. Range: two
//          cells to six grid diagonals.
//   walk   moves along the ground (in fly mode along the view); in one second about half the distance to what
//          the camera looks at.
//   chase  stays ahead and beside what is followed, and looks back at it: turning and zooming go on, about the
//          followed; panning and walking end it.
// The camera moves smoothly, within a few tenths of a second, on the same path at any frame rate. The eye
// stays one cell above the surface: if the ground is in the way, a turn rises, a zoom stops and a pan backs
// off.
class CameraControl {
  public:
    // `home`: the pose that overview() restores.
    CameraControl(const render::Camera& home, const sim::View& world, const render::Surroundings& around);

    const render::Camera& camera() const { return now_; }
    CameraMode mode() const { return mode_; }
    bool still() const;  // has arrived: the camera does not move until the next input

    void fly(bool on);  // leaves the top view
    void chase(bool on);
    // On: looks straight down on the image centre at the same scale, north up, from the next move() on. Off:
    // returns to the previous pose.
    void top_down(bool on);
    void set_home(const render::Camera& home) { home_ = home; }
    // Moves there, and orbits.
    void go_to(const render::Camera& pose);
    void overview() { go_to(home_); }
    // Is there at once, and orbits.
    void cut_to(const render::Camera& pose);

    // The vertical fields of view, degrees: of the camera, of its goal, and of where it returns to from the top view.
    struct FieldsOfView {
        double now = 0, goal = 0, before_top_down = 0;
    };
    FieldsOfView fields_of_view() const {
        return {now_.field_of_view_deg, goal_.field_of_view_deg, before_top_down_.field_of_view_deg};
    }
    // Another lens, at once, where the camera stands.
    void set_fields_of_view(const FieldsOfView& set) {
        now_.field_of_view_deg = set.now, goal_.field_of_view_deg = set.goal;
        before_top_down_.field_of_view_deg = set.before_top_down;
    }

    // Applies the input of a frame. `aspect`: image width / height. Held keys count for at most 0.25 s per
    // frame.
    void move(const CameraWish& wish, const sim::View& world, const render::Surroundings& around,
              double aspect, double elapsed_s);

  private:
    void look_down(const CameraRoom& room);
    void take_hold(const CameraWish& wish, double aspect, const CameraRoom& room);
    void zoom(double steps, const CameraRoom& room);
    void turn(glm::dvec2 by, double aspect, const CameraRoom& room);
    void pan(const CameraWish& wish, glm::dvec2 to, double aspect, const CameraRoom& room);
    void walk(const CameraWish& wish, double seconds, const CameraRoom& room);
    void begin_chase(const CameraWish& wish, const CameraRoom& room);
    void follow(const CameraWish& wish, double seconds, const CameraRoom& room);
    void approach(double seconds, const CameraRoom& room);

    render::Camera home_, now_, goal_, before_top_down_;
    CameraMode mode_ = CameraMode::kOrbit, mode_before_top_down_ = CameraMode::kOrbit;
    Grip hold_;                                            // what stays fixed on the way to the goal
    CameraWish::Drag dragging_ = CameraWish::Drag::kNone;  // in the frame before
    bool chase_begins_ = false;                            // nothing was followed yet
    bool look_down_ = false;                               // requested; move() has not found the ground yet
};

}  // namespace game
