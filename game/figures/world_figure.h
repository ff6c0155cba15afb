#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "game/analysis/gallery.h"
#include "game/base/outcome.h"
#include "game/figures/page.h"
#include "render/view/camera.h"
#include "sim/engine.h"

namespace game {

// A shipped recording at some of its ticks.
struct WorldFigure {
    int number;  // in the paper
    std::string title, recording;
    std::vector<std::int64_t> ticks;  // ascending
    render::Camera camera;            // closer than the scene's
};
std::vector<WorldFigure> world_figures();

// Plays the recording without a window and draws it into `folder`. `gl`
// as in render::HeadlessContext::create. Errors: no such recording
// (status 2); no GL, or an image cannot be written (status 3).
Outcome<PageFigure> draw_world(const WorldFigure& figure, const std::filesystem::path& folder,
                               PictureSize size, const std::string& gl, const sim::StepOptions& options);

}  // namespace game
