#include "render/passes/shadow_pass.h"

#include "assets/shaders/slots.glsl"
#include "render/view/frame_block.h"

namespace render {

void ShadowPass::resize(const sim::Grid& grid) {
    if (grid == grid_) return;
    grid_ = grid;
    ceiling_texture_ = make_texture(GL_R32F, most_rays(grid), most_rows(grid), GL_LINEAR);
    is_new_ = true;
}

void ShadowPass::upload(const SunSweep& sweep) {
    const int first = is_new_ ? 0 : sweep.first_changed(),
              last = is_new_ ? sweep.rows() - 1 : sweep.last_changed();
    is_new_ = false;
    if (first > last) return;
    const auto skipped = static_cast<std::size_t>(first) * static_cast<std::size_t>(sweep.rays());
    glTextureSubImage2D(ceiling_texture_.name(), 0, 0, first, sweep.rays(), last - first + 1, GL_RED,
                        GL_FLOAT, sweep.ceilings().data() + skipped);
}

void ShadowPass::bind() const {
    glBindTextureUnit(SLOT_SUN_CEILING, ceiling_texture_.name());
}

}  // namespace render
