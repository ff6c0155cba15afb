#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include <tl/expected.hpp>

#include "render/frame_block.h"
#include "render/gl_handle.h"
#include "render/screen_tiles.h"
#include "render/trees_in_view.h"
#include "render/woods.h"

namespace render {

// Draws conifers and their shadows on the ground.
class TreesPass {
  public:
    static tl::expected<TreesPass, std::string> create(const std::filesystem::path& shaders);

    // Makes room for new woods, and lights them anew if the light comes from another side: a few hundredths of a second.
    void survey(const Woods& woods, const Surroundings& around, const FrameBlock& frame);
    // Finds the trees of a frame and, if only the world changed, marks those that fell, sank or rose.
    void find(const Woods& woods, const sim::View& world, const FlowSoFar& flow, const FrameBlock& frame,
              const OnScreen& screen, bool everything, ScreenTiles& tiles);
    // Draws colour and depth over what is drawn, in parts of the frame.
    void draw(std::span<const Rectangle> parts);

  private:
    void list(std::span<const Rectangle> parts);

    ProgramName shadow_, near_, far_, plain_;
    VertexArray no_vertices_;
    Buffer instances_;
    std::uint64_t known_ = 0;  // fingerprint of the woods
    glm::vec4 known_sun_{0};
    std::vector<TreeLight> lights_;
    TreesInView trees_;
    std::vector<Rectangle> seen_;  // of each drawn tree, once a part of a frame is drawn
    OnScreen screen_;
    // The trees of each part, one after the other, as they lie on the GPU; how many of each kind a part has.
    struct Part {
        Rectangle part;
        std::size_t first, near, far, with_shadow, all;
    };
    std::vector<DrawnTree> listed_;
    std::vector<Part> parts_;
    std::size_t room_ = 0;  // trees that instances_ can hold
};

}  // namespace render
