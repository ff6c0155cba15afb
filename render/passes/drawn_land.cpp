#include "render/passes/drawn_land.h"

#include <array>

#include "assets/shaders/slots.glsl"
#include "render/mountain/land.h"

namespace render {

void DrawnLand::bind(const FrameInput& input) {
    const bool has_land = input.has_land();
    const std::uint64_t wanted = has_land ? input.land->fingerprint : 0;
    if (known_ != wanted) {
        known_ = wanted;
        constexpr std::array<std::uint8_t, 4> kDry = {};
        const int columns = has_land ? input.land->columns : 1, rows = has_land ? input.land->rows : 1;
        texture_ = make_texture(GL_RGBA8, columns, rows, GL_LINEAR);
        glTextureSubImage2D(texture_.name(), 0, 0, 0, columns, rows, GL_RGBA, GL_UNSIGNED_BYTE,
                            has_land ? input.land->texels.data() : kDry.data());
    }
    glBindTextureUnit(SLOT_LAND, texture_.name());
}

}  // namespace render
