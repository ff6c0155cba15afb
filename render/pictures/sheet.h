#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "render/pictures/picture.h"

namespace render {

// A white page for antialiased drawing without GL. Positions are pixels from the top left corner, colours are
// sRGB 0 to 255. It avoids a dependency on a drawing library (cairo) for this page alone.
class Sheet {
  public:
    Sheet(int width, int height);

    // Draws a line from p to q, or a disc if both are the same point.
    void line(const glm::vec2& p, const glm::vec2& q, float thickness, const glm::vec3& colour);
    void triangle(const std::array<glm::vec2, 3>& corner, const glm::vec3& colour);

    // Fills a rectangle; `cover` gives the coverage at a pixel's middle, 0 … 1.
    template <class Cover>
    void paint(const glm::vec2& from, const glm::vec2& to, const Cover& cover, const glm::vec3& colour) {
        const int x0 = std::max(static_cast<int>(from.x), 0), y0 = std::max(static_cast<int>(from.y), 0);
        const int x1 = std::min(static_cast<int>(to.x), picture.width - 1);
        const int y1 = std::min(static_cast<int>(to.y), picture.height - 1);
        for (int y = y0; y <= y1; ++y)
            for (int x = x0; x <= x1; ++x) {
                const glm::vec2 middle(static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f);
                const float share = std::clamp(cover(middle), 0.f, 1.f);
                if (share == 0) continue;
                std::uint8_t* pixel =
                    &picture
                         .pixels[3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(picture.width) +
                                      static_cast<std::size_t>(x))];
                for (int c = 0; c < 3; ++c)
                    pixel[c] = static_cast<std::uint8_t>(
                        std::lround(static_cast<float>(pixel[c]) * (1 - share) + colour[c] * share));
            }
    }

    Picture picture;
};

}  // namespace render
