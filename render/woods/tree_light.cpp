#include "render/woods/tree_light.h"

#include <algorithm>
#include <cmath>

namespace render {
namespace {

constexpr float kLongestTreeShadow = 36;  // m

}  // namespace

TreeLight light_of(const Tree& tree, const Surroundings* around, const glm::vec3& sun) {
    const double flat = std::max(std::hypot(static_cast<double>(sun.x), static_cast<double>(sun.y)), 1e-3);
    const float length =
        std::min(tree.height * static_cast<float>(flat) / std::max(sun.z, 0.01f), kLongestTreeShadow);
    const glm::vec2 tip = glm::vec2(tree.foot) - glm::vec2(sun) * (length / static_cast<float>(flat));
    if (!around || around->empty()) return {1, glm::vec3(tip, tree.foot.z)};
    const double reach = Surroundings::kRoughReach * around->side();
    const glm::dvec3 from(tree.foot + glm::vec3(0, 0, 0.6f * tree.height));
    double light = 1;
    for (double t = 1.5 * around->cell(); t < reach && light > 0; t *= 1.1) {
        const glm::dvec3 p = from + glm::dvec3(sun) * (t / flat);
        if (p.z > around->highest()) break;
        light = std::min(light, 0.5 + (p.z - around->rough_height(p)) / (0.01 * t + 0.2 * around->cell()));
    }
    return {static_cast<float>(std::max(light, 0.0)),
            glm::vec3(tip, static_cast<float>(around->rough_height(glm::dvec2(tip))))};
}

void light_trees(const Woods& woods, const Surroundings& around, const glm::vec3& sun,
                 std::vector<TreeLight>& into) {
    into.clear();
    for (const Tree& tree : woods.trees()) into.push_back(light_of(tree, &around, sun));
}

}  // namespace render
