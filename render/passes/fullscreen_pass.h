#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include <tl/expected.hpp>

#include "render/gl_handle.h"

namespace render {

// Runs a fragment shader over the whole target, at infinite distance. The sky and tone passes use it.
class FullscreenPass {
  public:
    static tl::expected<FullscreenPass, std::string> create(
        const std::filesystem::path& shaders, const std::vector<std::string_view>& fragment_files);

    void draw_behind() const;   // only where nothing was drawn
    void draw_encoded() const;  // everywhere, from linear light to the sRGB target
    // A CPU renderer runs both sides of a branch, but no shader for blocks of pixels that the stencil rejects.
    void draw_marks() const;     // sets the stencil to 1 where the shader discards nothing; draws no colour
    void draw_on_marks() const;  // where the stencil is 1, in values of the target that are not linear

  private:
    void draw() const;

    ProgramName program_;
    VertexArray no_vertices_;  // core GL draws nothing without a vertex array
};

}  // namespace render
