#include "render/view/on_screen.h"

#include <cmath>
#include <limits>

#include <glm/common.hpp>
#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

#include "render/view/camera.h"

namespace render {

// A corner is the sum of three products, of which only six differ.
Rectangle OnScreen::box(const glm::vec3& lowest, const glm::vec3& highest) const {
    const glm::mat4& m = clip_from_world_;
    const glm::vec4 x[2] = {m[0] * lowest.x, m[0] * highest.x}, y[2] = {m[1] * lowest.y, m[1] * highest.y},
                    z[2] = {m[2] * lowest.z + m[3], m[2] * highest.z + m[3]};
    glm::vec2 least(std::numeric_limits<float>::max()), most(std::numeric_limits<float>::lowest());
    int left = 0, right = 0, below = 0, above = 0, behind = 0;  // corners beyond an edge of the frame
    for (int corner = 0; corner < 8; ++corner) {
        const glm::vec4 clip = x[corner & 1] + y[corner >> 1 & 1] + z[corner >> 2];
        left += clip.x < -clip.w;
        right += clip.x > clip.w;
        below += clip.y < -clip.w;
        above += clip.y > clip.w;
        if (clip.w < static_cast<float>(kNear)) {
            ++behind;
            continue;
        }
        const glm::vec2 ndc = glm::vec2(clip) / clip.w;
        least = glm::min(least, ndc);
        most = glm::max(most, ndc);
    }
    if (left == 8 || right == 8 || below == 8 || above == 8 || behind == 8) return {};
    if (behind > 0) return all();
    const auto sample = [](float ndc, int samples, int beside) {
        return static_cast<int>(
                   std::floor((0.5f + 0.5f * glm::clamp(ndc, -2.f, 2.f)) * static_cast<float>(samples))) +
               beside;
    };
    return common_part({sample(least.x, width_, -1), sample(least.y, height_, -1), sample(most.x, width_, 2),
                        sample(most.y, height_, 2)},
                       all());
}

}  // namespace render
