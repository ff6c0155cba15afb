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

  private:
    void draw() const;

    ProgramName program_;
    VertexArray no_vertices_;  // core GL draws nothing without a vertex array
};

}  // namespace render
