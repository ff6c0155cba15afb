#include "render/passes/lens_pass.h"

#include <utility>

#include "assets/shaders/slots.glsl"

namespace render {

tl::expected<LensPass, std::string> LensPass::create(const std::filesystem::path& shaders) {
    auto program = link_program(shaders, {{GL_VERTEX_SHADER, {"fullscreen.vert"}},
                                          {GL_FRAGMENT_SHADER, {"slots.glsl", "lens.frag"}}});
    if (!program) return tl::unexpected(program.error());
    LensPass pass;
    pass.program_ = std::move(*program);
    pass.no_vertices_ = make_vertex_array();
    return pass;
}

GLuint LensPass::draw(const Target& frame, GLuint lit, const Lens& lens) {
    if (width_ != frame.width() || height_ != frame.height()) {
        width_ = frame.width(), height_ = frame.height();
        taken_ = make_texture(GL_RGBA16F, width_, height_, GL_NEAREST);
        output_ = make_framebuffer();
        glNamedFramebufferTexture(output_.name(), GL_COLOR_ATTACHMENT0, taken_.name(), 0);
    }
    glBindFramebuffer(GL_FRAMEBUFFER, output_.name());
    glViewport(0, 0, width_, height_);
    glBindTextureUnit(SLOT_COLOUR, lit);
    glUseProgram(program_.name());
    glUniform1f(0, static_cast<float>(lens.exposure));
    glBindVertexArray(no_vertices_.name());
    glDrawArrays(GL_TRIANGLES, 0, 3);
    return taken_.name();
}

void LensPass::forget() {
    width_ = height_ = 0;
    taken_ = Texture();
    output_ = Framebuffer();
}

}  // namespace render
