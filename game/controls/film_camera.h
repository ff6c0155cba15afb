#pragma once

#include <optional>
#include <string_view>

#include "game/controls/camera_control.h"
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
};
std::optional<FilmView> film_view_from(std::string_view name);  // "scene", "chase", "front", "top"

// The camera of each image of a film. That of kChase moves as in the window; all others stay at home.
class FilmCamera {
  public:
    FilmCamera(FilmView view, const render::Camera& home, const sim::View& world,
               const render::Surroundings& around);

    const render::Camera& camera() const { return camera_; }
    // Continues to the next image. `aspect`: its width / height.
    void move(const sim::View& world, const render::Surroundings& around, double aspect, double elapsed_s);

  private:
    FilmView view_;
    render::Camera camera_;
    SlideFront front_;
    CameraControl control_;
};

}  // namespace game
