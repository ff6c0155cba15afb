#include "render/passes/drawn_land.h"

#include "assets/shaders/slots.glsl"
#include "render/mountain/land.h"

namespace render {

void DrawnLand::bind(const FrameInput& input) {
    const std::uint64_t wanted =
        input.look.date && input.surrounded() ? input.surroundings->fingerprint() : 0;
    if (known_ != wanted) {
        known_ = wanted;
        const Land land = wanted != 0 ? land_of(*input.surroundings) : Land{1, 1, {0, 0, 0, 0}};
        texture_ = make_texture(GL_RGBA8, land.columns, land.rows, GL_LINEAR);
        glTextureSubImage2D(texture_.name(), 0, 0, 0, land.columns, land.rows, GL_RGBA, GL_UNSIGNED_BYTE,
                            land.texels.data());
    }
    glBindTextureUnit(SLOT_LAND, texture_.name());
}

}  // namespace render
