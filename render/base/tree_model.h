#pragma once

#include <vector>

#include <glm/vec3.hpp>

#include "render/base/ramp.h"

namespace render {

// What trees that are grown for pictures consist of. Lengths are in heights of the tree, its foot at the origin, z up. The same
// bits on every machine.

// A triangle of needles, leaves, bark or snow. Both of its sides are seen.
struct TreeFace {
    glm::vec3 a, b, c;
    glm::vec3 normal;  // unit vector, by which it is lit
    float other;       // share that is white with snow; of a tree in leaf, that is bark; 0 to 1
    float light;       // share of the light that reaches it through the crown, 0 to 1
};
using TreeModel = std::vector<TreeFace>;

// Radii of crowns.
inline constexpr float kConiferRadius = 0.19f;  // of a slim tree
inline constexpr float kCushionRadius = 0.8f;   // of a dwarf pine
inline constexpr float kGroupRadius = 1;        // of some trees side by side
inline constexpr float kBeechRadius = 0.26f;
inline constexpr float kBirchRadius = 0.185f;
inline constexpr float kBushRadius = 0.58f;

// One of some trees side by side: where its foot is, and its size.
struct Beside {
    float x, y, wide, high;
    float bright;  // factor on its light
};
// Within a stand feet are dark: the share of the light that reaches them, how much more the top has, and the heights between.
struct Feet {
    float least, more, from, to;
};
inline void add_tree(TreeModel& group, const TreeModel& tree, const Beside& at, const Feet& feet) {
    const auto put = [&](glm::vec3 p) {
        return glm::vec3(p.x * at.wide + at.x, p.y * at.wide + at.y, p.z * at.high);
    };
    for (const TreeFace& face : tree) {
        const float light =
            face.light * at.bright * (feet.least + feet.more * ramp(feet.from, feet.to, face.a.z));
        group.push_back({put(face.a), put(face.b), put(face.c), face.normal, face.other, light});
    }
}

}  // namespace render
