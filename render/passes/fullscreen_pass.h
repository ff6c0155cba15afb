#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <tl/expected.hpp>

#include "render/base/rectangle.h"
#include "render/gl/gl_handle.h"

namespace render {

// Runs a fragment shader over the target, at infinite distance. The sky and tone passes use it.
class FullscreenPass {
  public:
    static tl::expected<FullscreenPass, std::string> create(
        const std::filesystem::path& shaders, const std::vector<std::string_view>& fragment_files);

    using Parts = std::span<const Rectangle>;  // of the target
    void draw() const;                         // everywhere
    void draw_behind(Parts parts) const;       // only where nothing was drawn
    void draw_encoded(Parts parts) const;      // from linear light to the sRGB target
    // A CPU renderer runs both sides of a branch, but no shader for blocks of pixels that the stencil rejects.
    // Sets the stencil to 1 where the shader discards nothing; draws no colour.
    void draw_marks(Parts parts) const;
    // Draws where the stencil is 1, in values of the target that are not linear.
    void draw_on_marks(Parts parts) const;

  private:
    ProgramName program_;
    VertexArray no_vertices_;  // core GL draws nothing without a vertex array
};

}  // namespace render
