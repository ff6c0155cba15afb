#pragma once

#include <filesystem>
#include <string>

#include <tl/expected.hpp>

#include "render/gl/gl_handle.h"
#include "render/gl/program.h"
#include "render/passes/target.h"
#include "render/view/lens.h"

namespace render {

// The light of a frame as a lens and its exposure let it fall on a photo.
class LensPass {
  public:
    static tl::expected<LensPass, std::string> create(const std::filesystem::path& shaders);

    // Draws the photo of `lit`, the linear colour of every pixel of `frame`, and returns the texture that has it, until
    // the next call.
    GLuint draw(const Target& frame, GLuint lit, const Lens& lens);
    // Frees its memory, which only photos need.
    void forget();

  private:
    ProgramName program_;
    VertexArray no_vertices_;
    int width_ = 0, height_ = 0;
    Texture taken_;
    Framebuffer output_;
};

}  // namespace render
