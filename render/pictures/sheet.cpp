#include "render/pictures/sheet.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace render {

Sheet::Sheet(int width, int height) {
    picture.width = width, picture.height = height;
    picture.pixels.assign(3 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height), 255);
}

void Sheet::line(const glm::vec2& p, const glm::vec2& q, float thickness, const glm::vec3& colour) {
    const float reach = thickness / 2 + 1;
    const glm::vec2 along = q - p;
    const float length2 = glm::dot(along, along);
    paint(
        glm::min(p, q) - reach, glm::max(p, q) + reach,
        [&](const glm::vec2& at) {
            const float share = length2 > 0 ? std::clamp(glm::dot(at - p, along) / length2, 0.f, 1.f) : 0.f;
            return thickness / 2 + 0.5f - glm::length(at - p - share * along);
        },
        colour);
}

void Sheet::triangle(const std::array<glm::vec2, 3>& corner, const glm::vec3& colour) {
    const auto side = [](const glm::vec2& from, const glm::vec2& to, const glm::vec2& at) {
        const glm::vec2 along = to - from, away = at - from;
        return (along.x * away.y - along.y * away.x) / glm::length(along);
    };
    const float turn = side(corner[0], corner[1], corner[2]) > 0 ? 1.f : -1.f;
    paint(
        glm::min(corner[0], glm::min(corner[1], corner[2])) - 1.f,
        glm::max(corner[0], glm::max(corner[1], corner[2])) + 1.f,
        [&](const glm::vec2& at) {
            float least = 1;
            for (int k = 0; k < 3; ++k)
                least = std::min(least, turn * side(corner[k], corner[(k + 1) % 3], at) + 0.5f);
            return least;
        },
        colour);
}

}  // namespace render
