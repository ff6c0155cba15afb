#pragma once

#include <memory>

#include "game/controls/action.h"
#include "game/ui/facts.h"
#include "game/ui/widgets.h"
#include "render/gl/gl_handle.h"

namespace game::ui {

// The map of the result card. A click on it turns the camera to that place.
class CardMap {
  public:
    // Fills the width of the window, if `most_height`, px, allows it. Shows the picture from the frame after the first
    // one on.
    void show(Widgets& widgets, const std::shared_ptr<const SlideMap>& map, float most_height,
              Actions& actions);
    // Makes the texture of a map that was shown first in this frame. Needs the screen's GL context.
    void upload_if_new();

  private:
    std::shared_ptr<const SlideMap> shown_, uploaded_;
    render::Texture texture_;
};

}  // namespace game::ui
