#pragma once

#include <cstddef>
#include <optional>

#include "game/controls/slide_front.h"
#include "render/mountain/surroundings.h"
#include "render/view/camera.h"
#include "sim/world/state.h"

namespace game {

// The shots of a film of a slide: cameras that stand, of which an image is finished once and then only what moves is drawn.
// It begins with the view over the whole, goes down to the path of the front, on one side of it and then on the other, and
// ends with the whole again.
class Shots {
  public:
    explicit Shots(const render::Camera& whole) : whole_(whole) {}

    struct Seen {
        const render::Camera& camera;  // now
        const std::optional<SlideFront::Front>& front;
        const sim::View& world;
        const render::Surroundings& around;
        double aspect = 1;  // of the image, width / height
        double now_s = 0;   // never less than before
    };
    // Call once per frame. The camera of the next shot, if this one is over.
    std::optional<render::Camera> next(const Seen& seen);

  private:
    render::Camera whole_;
    std::optional<double> began_s_;  // the shot
    std::size_t shot_ = 0;
    std::optional<double> left_s_;  // since when the front is out of view
};

}  // namespace game
