#pragma once

#include <cstddef>
#include <memory>

#include "game/controls/action.h"
#include "game/ui/facts.h"
#include "game/ui/widgets.h"
#include "render/gl/gl_handle.h"

namespace game::ui {

// Of a mark on a map. What became of a house shows by shape on the card too.
constexpr ImU32 mark_colour(SlideMap::Mark::Kind kind) {
    constexpr ImU32 kColours[]{IM_COL32(255, 214, 92, 255), IM_COL32(244, 246, 248, 255),
                               IM_COL32(240, 160, 60, 255), IM_COL32(214, 60, 52, 255)};
    return kColours[static_cast<std::size_t>(kind)];
}

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
