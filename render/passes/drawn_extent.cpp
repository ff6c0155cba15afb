#include "render/passes/drawn_extent.h"

#include <algorithm>

#include "assets/shaders/slots.glsl"
#include "sim/core/check.h"

namespace render {

std::span<const glm::ivec2> DrawnExtent::send(std::span<const std::uint8_t> extent, const sim::Grid& grid) {
    changed_.clear();
    if (extent.empty()) return {};
    CHECK(extent.size() == grid.size());
    if (nx_ != grid.nx || ny_ != grid.ny) {
        nx_ = grid.nx, ny_ = grid.ny;
        texture_ = make_texture(GL_R8, nx_, ny_, GL_LINEAR);
        sent_.clear();
    }
    if (std::ranges::equal(sent_, extent)) return {};
    sent_.resize(extent.size());  // of a new texture: all of it is drawn anew in any case
    for (std::size_t i = 0; i < extent.size(); ++i)
        if (sent_[i] != extent[i])
            changed_.emplace_back(static_cast<int>(i) % nx_, static_cast<int>(i) / nx_);
    std::ranges::copy(extent, sent_.begin());
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    glTextureSubImage2D(texture_.name(), 0, 0, 0, nx_, ny_, GL_RED, GL_UNSIGNED_BYTE, sent_.data());
    glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
    return changed_;
}

void DrawnExtent::bind() const {
    glBindTextureUnit(SLOT_EXTENT, texture_.name());
}

}  // namespace render
