#include "render/passes/shadow_pass.h"

#include "assets/shaders/slots.glsl"
#include "render/program.h"

namespace render {

tl::expected<ShadowPass, std::string> ShadowPass::create(const std::filesystem::path& shaders) {
    auto program = link_program(shaders, {{GL_COMPUTE_SHADER, {"slots.glsl", "frame.glsl", "shadow.comp"}}});
    if (!program) return tl::unexpected(program.error());
    ShadowPass pass;
    pass.program_ = std::move(*program);
    return pass;
}

void ShadowPass::resize(const sim::Grid& grid) {
    if (grid == grid_) return;
    grid_ = grid;
    ceiling_texture_ = make_texture(GL_R32F, most_rays(grid), most_rows(grid), GL_LINEAR);
}

void ShadowPass::run(const FrameBlock& frame) const {
    glUseProgram(program_.name());
    glBindImageTexture(IMAGE_SUN_CEILING, ceiling_texture_.name(), 0, GL_FALSE, 0, GL_WRITE_ONLY, GL_R32F);
    glDispatchCompute(static_cast<GLuint>((frame.size.z + GROUP_ROW - 1) / GROUP_ROW), 1, 1);
    glMemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT);
}

void ShadowPass::bind() const {
    glBindTextureUnit(SLOT_SUN_CEILING, ceiling_texture_.name());
}

}  // namespace render
