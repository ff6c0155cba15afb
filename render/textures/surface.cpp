#include "render/textures/surface.h"

#include <glm/common.hpp>

namespace render {

glm::vec3 colour_at(std::span<const ColourStop> ramp, float height) {
    if (height <= ramp.front().height) return ramp.front().colour;
    for (std::size_t i = 1; i < ramp.size(); ++i) {
        const ColourStop &below = ramp[i - 1], &above = ramp[i];
        if (height < above.height)
            return glm::mix(below.colour, above.colour,
                            (height - below.height) / (above.height - below.height));
    }
    return ramp.back().colour;
}

}  // namespace render
