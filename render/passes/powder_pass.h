#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include <tl/expected.hpp>

#include "render/flow/powder_puffs.h"
#include "render/gl/gl_handle.h"
#include "render/view/frame_block.h"
#include "render/view/look.h"
#include "sim/powder/cloud.h"

namespace render {

// Draws powder and dust in the air. Soft as it is, it is drawn at a half to a sixth of the resolution, whatever
// fits a budget of pixels, and laid over the frame by distance.
class PowderPass {
  public:
    static tl::expected<PowderPass, std::string> create(const std::filesystem::path& shaders);

    // Finds what is in view of a frame of `width` by `height` samples. Returns false if that is nothing; then do
    // not draw. `strength`: factor on the opacity. `is_part`: of an image whose other parts must have as many pixels.
    bool find(std::span<const sim::powder::Puff> puffs, const FrameBlock& frame, const Look& look,
              float strength, int width, int height, bool is_part);
    // Draws what was found into buffers of its own. Reads SLOT_SCENE_DEPTH, SLOT_DETAIL, SLOT_SUN_CEILING.
    void draw() const;
    // The disjoint parts of the frame where it and its shadow may be seen.
    std::span<const Rectangle> seen() const { return seen_; }
    // Lays it over the bound frame, with its shadow on the ground.
    void lay_over() const;

  private:
    void resize(int width, int height);
    int across() const;  // of the textures
    int up() const;
    void fill(const ProgramName& program) const;

    ProgramName reach_, puffs_, light_, over_;
    VertexArray no_vertices_, vertex_array_;
    Buffer instances_, block_;
    Texture shade_map_, farthest_, thick_, lower_, lit_, hidden_;
    Framebuffer farthest_frame_, thick_frame_, lit_frame_;
    int width_ = 0, height_ = 0;  // of the frame, samples
    int divisor_ = 1;
    PowderPuffs cloud_;
    std::vector<Rectangle> seen_;
};

}  // namespace render
