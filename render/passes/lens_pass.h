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
//
//     linear colour, depth ──▶ circles: colour, radius ──▶ largest radius of each block ──▶ and of those around it
//                                 └────────────────── gathered, as far as these reach ◀────────────┘
//
// Without blur the colours are only exposed.
class LensPass {
  public:
    static tl::expected<LensPass, std::string> create(const std::filesystem::path& shaders);

    // Draws the photo of `lit`, the linear colour of every pixel of `frame`, and returns the texture that has it, until
    // the next call. `image_height`: of the image of which the frame is a part, or its own, pixels.
    GLuint draw(const Target& frame, GLuint lit, const Lens& lens, int image_height);
    // Frees its memory, which only photos need.
    void forget();

  private:
    // A texture that is drawn to.
    struct Layer {
        Texture texture;
        Framebuffer framebuffer;
        int width = 0, height = 0;

        void resize(GLenum format, int to_width, int to_height);
        void forget() { *this = {}; }
    };
    void blur(const Target& frame, GLuint lit, const Lens& lens, int image_height);
    void fill(const Layer& layer) const;  // by the program in use

    ProgramName expose_, circles_, reach_, near_, gather_;
    VertexArray no_vertices_;
    Layer taken_, circle_, block_, near_block_;
};

}  // namespace render
