#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include <tl/expected.hpp>

#include "render/gl_handle.h"

namespace render {

// A fragment shader over the whole target, at infinite distance. The sky and the tone pass are two of these.
class FullscreenPass {
  public:
    static tl::expected<FullscreenPass, std::string> create(
        const std::filesystem::path& shaders, const std::vector<std::string_view>& fragment_files);

    void draw_behind() const;   // only where nothing was drawn
    void draw_on() const;       // only where something was; depth stays as it is, so the shader may read it
    void draw_encoded() const;  // everywhere, linear light to the sRGB of the target

  private:
    void draw() const;

    ProgramName program_;
    VertexArray no_vertices_;  // core GL draws nothing without one
};

}  // namespace render
