#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "render/view/camera.h"
#include "render/view/look.h"

namespace game {

// A fixed view of the page that `couloir gallery` draws.
struct GalleryView {
    const char* name;                      // of its image: NAME.png
    const char* title;                     // for people
    const char* scene;                     // shipped; empty: the hill of --terrain
    std::optional<std::int64_t> tick;      // none: at rest
    std::optional<render::Camera> camera;  // none: the scene's own, or an overview
    render::Light light;
    std::optional<render::Date> date = std::nullopt;  // none: the scene's own
};

// All views, in the page's order. Views of one scene follow each other by tick, so that a scene is simulated
// once.
std::vector<GalleryView> gallery_views();

}  // namespace game
