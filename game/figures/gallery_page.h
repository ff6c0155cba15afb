#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>

#include "render/gl/draw_times.h"
#include "render/view/camera.h"
#include "render/view/look.h"

namespace game {

// A drawn view, with what is needed to draw it again and to tell whether the world or only its look changed.
struct DrawnView {
    std::string file, title, scene;
    std::int64_t tick = 0;
    bool still_moving = false;  // although the view is of a world at rest: the longest run did not get there
    std::string state_hash;
    render::Camera camera;
    render::Light light;
    render::DrawTimes moving, fast, fine;  // of one frame by quality
};

// A page that needs only the images beside it. `note`: a sentence about all views; empty: none. `reload_s`: see
// begin_page().
std::string gallery_page(std::span<const DrawnView> views, const render::DrawnBy& drawn_by,
                         const std::string& note, const std::string& made_by,
                         std::optional<int> reload_s = std::nullopt);

}  // namespace game
