#pragma once

#include <filesystem>
#include <string>

#include <tl/expected.hpp>

#include "render/frame_block.h"
#include "render/gl_handle.h"
#include "sim/core/grid.h"

namespace render {

// Computes, for every vertex, the height below which the sun is hidden. Reads SLOT_RELIEF, writes
// SLOT_SUN_CEILING.
class ShadowPass {
  public:
    static tl::expected<ShadowPass, std::string> create(const std::filesystem::path& shaders);

    void resize(const sim::Grid& grid);
    void run(const FrameBlock& frame) const;  // the relief must be bound
    void bind() const;

  private:
    ProgramName program_;
    sim::Grid grid_;
    Texture ceiling_texture_;
};

}  // namespace render
