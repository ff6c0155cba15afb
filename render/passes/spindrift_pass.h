#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include <glm/vec4.hpp>
#include <tl/expected.hpp>

#include "render/gl/gl_handle.h"
#include "render/mountain/spindrift.h"
#include "render/view/frame_block.h"
#include "render/view/on_screen.h"
#include "render/view/wind.h"

namespace render {

// Draws spindrift: snow that wind blows off sharp ridges. Each place has a soft ribbon along the wind.
class SpindriftPass {
  public:
    static tl::expected<SpindriftPass, std::string> create(const std::filesystem::path& shaders);

    // Finds what is in view at a time of the world, s. Returns false if that is nothing; then do not draw.
    bool find(const Surroundings& around, const Wind& wind, double seconds, const FrameBlock& frame,
              const OnScreen& screen);
    // The parts of the frame where it may be seen. They overlap.
    std::span<const Rectangle> seen() const { return seen_; }
    // Over the bound frame. Reads SLOT_SCENE_DEPTH and SLOT_DETAIL.
    void draw() const;

  private:
    ProgramName program_;
    VertexArray vertex_array_;
    Buffer instances_;
    std::uint64_t known_ = 0;
    Wind known_wind_;
    glm::vec4 known_sun_{0};
    Ridges ridges_;
    std::vector<SpindriftPlace> drawn_;
    std::vector<Rectangle> seen_;
    glm::vec4 wind_{0}, phase_{0};
};

}  // namespace render
