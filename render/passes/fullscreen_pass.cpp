#include "render/passes/fullscreen_pass.h"

#include "render/gl/program.h"
#include "render/gl/scissor.h"

namespace render {

tl::expected<FullscreenPass, std::string> FullscreenPass::create(
    const std::filesystem::path& shaders, const std::vector<std::string_view>& fragment_files) {
    auto program = link_program(
        shaders, {{GL_VERTEX_SHADER, {"fullscreen.vert"}}, {GL_FRAGMENT_SHADER, fragment_files}});
    if (!program) return tl::unexpected(program.error());
    FullscreenPass pass;
    pass.program_ = std::move(*program);
    pass.no_vertices_ = make_vertex_array();
    return pass;
}

void FullscreenPass::draw_behind(Parts parts) const {
    const Enabled depth_test(GL_DEPTH_TEST);
    within(parts, [&] { draw(); });
}

void FullscreenPass::draw_encoded(Parts parts) const {
    const Enabled encoding(GL_FRAMEBUFFER_SRGB);
    within(parts, [&] { draw(); });
}

void FullscreenPass::draw_marks(Parts parts) const {
    const Enabled stencil_test(GL_STENCIL_TEST);
    glStencilFunc(GL_ALWAYS, 1, ~0u);
    glStencilOp(GL_KEEP, GL_KEEP, GL_REPLACE);
    glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
    within(parts, [&] { draw(); });
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    glStencilOp(GL_KEEP, GL_KEEP, GL_KEEP);
    glStencilFunc(GL_ALWAYS, 0, ~0u);
}

void FullscreenPass::draw_on_marks(Parts parts) const {
    const Enabled stencil_test(GL_STENCIL_TEST);
    glStencilFunc(GL_EQUAL, 1, ~0u);
    within(parts, [&] { draw(); });
    glStencilFunc(GL_ALWAYS, 0, ~0u);
}

void FullscreenPass::draw() const {
    glUseProgram(program_.name());
    glBindVertexArray(no_vertices_.name());
    glDrawArrays(GL_TRIANGLES, 0, 3);
}

}  // namespace render
