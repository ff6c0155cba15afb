#pragma once

#include <optional>
#include <span>
#include <string_view>

#include "game/controls/camera_control.h"
#include "game/controls/camera_spline.h"
#include "game/controls/slide_front.h"
#include "render/mountain/surroundings.h"
#include "render/view/camera.h"
#include "sim/world/state.h"

namespace game {

// From where a film is seen.
enum class FilmView {
    kScene,  // the camera of the scene or recording, which stands
    kChase,  // ahead of the front, and looks back at it, as V does in the window
    kFront,  // from where the slide comes to rest, up the way it came
    kTop,    // straight above all of the ground, north up
    kPath,   // along a camera path, above the ground as in the window
};
std::optional<FilmView> film_view_from(std::string_view name);  // "scene", "chase", "front", "top", "path"

// The camera of each image of a film. That of kChase moves as in the window, that of kPath along its keys; all others stay
// at home.
class FilmCamera {
  public:
    struct Time {
        double elapsed_s;  // since the last image
        double world_s;    // of the world, in this image
    };
    // `path`: of kPath, with a key at least. The first image is at `begins_s` of the world.
    FilmCamera(FilmView view, const render::Camera& home, const sim::View& world,
               const render::Surroundings& around, std::span<const CameraKey> path = {}, double begins_s = 0);

    const render::Camera& camera() const { return camera_; }
    // Continues to the next image. `aspect`: its width / height.
    void move(const sim::View& world, const render::Surroundings& around, double aspect, const Time& time);

  private:
    void follow_path(const sim::View& world, const render::Surroundings& around, double world_s);

    FilmView view_;
    std::optional<CameraSpline> path_;
    render::Camera camera_;
    SlideFront front_;
    CameraControl control_;
};

}  // namespace game
