#include "render/passes/drawn_water.h"

#include <algorithm>

#include "assets/shaders/slots.glsl"
#include "render/base/same_inside.h"

namespace render {

std::span<const glm::ivec2> DrawnWater::send(const FrameInput& input) {
    changed_.clear();
    if (input.marks.overlay != Overlay::kWater && !input.shows_wet_soil()) return changed_;
    const sim::Grid& grid = input.world.grid;
    if (grid_ != grid) {
        grid_ = grid;
        texture_ = make_texture(GL_R32F, grid.nx, grid.ny, GL_NEAREST);
        sent_ = sim::Field<float>(grid);
        wet_ = 0;
        changed_.reserve(grid.size());
        glClearTexImage(texture_.name(), 0, GL_RED, GL_FLOAT, nullptr);
    }
    for (int y = 0; y < grid.ny; ++y) {
        if (input.world.things && same_row(sent_, input.world.things->water, y)) continue;
        for (int x = 0; x < grid.nx; ++x) {
            const float now = input.world.things ? input.world.things->water(x, y) : 0;
            if (now == sent_(x, y)) continue;
            wet_ += (now != 0) - (sent_(x, y) != 0);
            sent_(x, y) = now;
            changed_.emplace_back(x, y);
        }
    }
    if (changed_.empty()) return changed_;
    const int first = changed_.front().y, last = changed_.back().y;
    glPixelStorei(GL_UNPACK_ROW_LENGTH, sent_.stride());  // a field's rows include halo and padding
    glTextureSubImage2D(texture_.name(), 0, 0, first, grid.nx, last - first + 1, GL_RED, GL_FLOAT,
                        sent_.row(first));
    glPixelStorei(GL_UNPACK_ROW_LENGTH, 0);
    return changed_;
}

void DrawnWater::bind() const {
    glBindTextureUnit(SLOT_WATER, texture_.name());
}

}  // namespace render
