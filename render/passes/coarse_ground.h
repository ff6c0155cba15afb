#pragma once

#include <filesystem>
#include <string>

#include <tl/expected.hpp>

#include "render/gl/gl_handle.h"
#include "render/passes/fullscreen_pass.h"
#include "render/passes/rectangle_pass.h"
#include "render/passes/target.h"

namespace render {

// Shades the ground of a frame that moves for every second sample along x and y, and spreads its colours over the samples
// between, each from those around it that are as far away. So edges are as fine as the frame, and shading, which is most
// of a frame's time without a GPU, costs a quarter.
//
//     depth of the frame ──▶ of every second sample ──▶ their flow and ground, lit ──▶ spread over the frame
class CoarseGround {
  public:
    static tl::expected<CoarseGround, std::string> create(const std::filesystem::path& shaders);

    // Call before every such frame.
    void resize(const Target& frame) {
        target_.resize((frame.samples_across() + 1) / 2, (frame.samples_up() + 1) / 2, 1);
    }
    // Draw the flow and shade the ground there, by coarse_frame_block(), between begin() and spread().
    const Target& target() const { return target_; }

    // Reads the depth of the frame's ground. Leaves the target bound.
    void begin(const Target& frame) const;
    // Draws the frame's ground, with ring, outlines and contours if it is `marked`. Leaves the frame's scene bound.
    void spread(const Target& frame, bool marked);

  private:
    Target target_;
    FullscreenPass reduce_;
    RectanglePass plain_, marked_;
    Rectangles all_;
};

}  // namespace render
