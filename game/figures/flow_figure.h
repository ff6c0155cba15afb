#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "game/base/outcome.h"
#include "game/figures/page.h"
#include "render/view/flow_pattern.h"
#include "sim/core/workers.h"
#include "sim/fields/test_flows.h"

namespace game {

// A flow on the unit square with a known front, and its advected texture: drawn without and with cuts along
// the front, side by side, and below that the stretch of each texture.
struct FlowFigure {
    int number;  // in the paper
    std::string title;
    sim::fields::TestFlow flow;
    int squares;     // of the mesh, along each side
    double seconds;  // how long textures have been advected
    render::FlowPattern pattern;
    double repeats;       // of the pattern along a side
    bool detail = false;  // a second image shows the mesh and its points
};
std::vector<FlowFigure> flow_figures();

// Draws the figures without a window.
class Studio {
  public:
    // `gl` as in render::HeadlessContext::create. Errors: no GL (status 3).
    static Outcome<Studio> open(const std::string& gl);
    ~Studio();
    Studio(Studio&&) noexcept;
    Studio& operator=(Studio&&) noexcept;

    // Writes them into `folder`; each square is `pixels` wide. Bit-identical for any number of workers.
    // Errors: a texture is missing, or an image cannot be written (status 3).
    Outcome<PageFigure> draw(const FlowFigure& figure, const std::filesystem::path& folder, int pixels,
                             sim::Workers& workers);

    std::string renderer_name() const;

  private:
    struct Parts;
    explicit Studio(std::unique_ptr<Parts> parts);
    std::unique_ptr<Parts> parts_;
};

}  // namespace game
