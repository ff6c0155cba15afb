#include "render/passes/drawn_probability.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "assets/shaders/slots.glsl"
#include "sim/core/check.h"

namespace render {

void DrawnProbability::bind(const FrameInput& input) {
    const sim::Grid& grid = input.world.grid;
    if (sent_ != input.marks.probability || grid_ != grid) {
        std::vector<float> percent(grid.size());
        if (input.marks.probability != 0) {
            CHECK(input.probability.size() == grid.size());
            std::ranges::transform(input.probability, percent.begin(),
                                   [](float share) { return std::isnan(share) ? 0.f : 100 * share; });
        }
        if (grid_ != grid || sent_ < 0) texture_ = make_texture(GL_R32F, grid.nx, grid.ny, GL_NEAREST);
        glTextureSubImage2D(texture_.name(), 0, 0, 0, grid.nx, grid.ny, GL_RED, GL_FLOAT, percent.data());
        grid_ = grid, sent_ = input.marks.probability;
    }
    glBindTextureUnit(SLOT_PROBABILITY, texture_.name());
}

}  // namespace render
