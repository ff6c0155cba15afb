#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include <tl/expected.hpp>

#include "render/frame_block.h"
#include "render/gl_handle.h"
#include "render/trees_in_view.h"
#include "render/woods.h"

namespace render {

// Draws conifers and their shadows on the ground.
class TreesPass {
  public:
    static tl::expected<TreesPass, std::string> create(const std::filesystem::path& shaders);

    // Finds the trees of a frame. Returns false if there are none. Makes room for new woods, and lights them anew if the
    // light comes from another side: a few hundredths of a second.
    bool find(const Woods& woods, const Surroundings& around, const sim::View& world, const FlowSoFar& flow,
              const FrameBlock& frame);
    // Draws colour and depth over what is drawn.
    void draw() const;

  private:
    ProgramName shadow_, near_, far_, plain_;
    VertexArray no_vertices_;
    Buffer instances_;
    std::uint64_t known_ = 0;  // fingerprint of the woods
    glm::vec4 known_sun_{0};
    std::vector<TreeLight> lights_;
    TreesInView trees_;
};

}  // namespace render
