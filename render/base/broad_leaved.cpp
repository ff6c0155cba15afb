#include "render/base/broad_leaved.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

#include "render/base/chance.h"
#include "render/base/ramp.h"

namespace render {
namespace {

constexpr glm::vec3 kUpward{0, 0, 1};
constexpr float kGoldenTurn = 0.381966f;  // between one limb and the next

// What a kind of tree is like.
struct Habit {
    float radius;        // of the crown
    float base;          // height of its lowest leaves
    float widest;        // where it is widest, 0 at its base to 1 at its top
    float pointed;       // how far its upper part is a cone, 0 to 1
    float stem;          // radius at the foot
    float stem_top;      // height at which the stem has divided
    int limbs;           // each with a cloud of leaves at its end
    float cloud;         // radius of a cloud
    int sprays;          // of leaves in a cloud
    float spray;         // half the length of a spray
    float hanging;       // share of the sprays that hang below their cloud
    float light_inside;  // share of the light that reaches the middle of the crown
};

// Radius of the crown at a height.
float crown_at(const Habit& habit, float z) {
    const float u = std::clamp((z - habit.base) / (1 - habit.base), 0.f, 1.f);
    if (u < habit.widest) {
        const float x = 1 - u / habit.widest;
        return habit.radius * std::sqrt(std::max(1 - x * x, 0.f));
    }
    const float x = (u - habit.widest) / (1 - habit.widest);
    return habit.radius * glm::mix(std::sqrt(std::max(1 - x * x, 0.f)), 1 - x, habit.pointed);
}

glm::vec3 any_direction(Chance& chance) {
    const glm::vec3 aside = direction(chance());
    const float z = chance(-1, 1);
    return aside * std::sqrt(std::max(1 - z * z, 0.f)) + z * kUpward;
}

// A limb or a branch: it leaves its foot one way and arrives at its end another way.
struct Curve {
    glm::vec3 from, bend, to;
    glm::vec3 at(float t) const { return (1 - t) * (1 - t) * from + 2 * t * (1 - t) * bend + t * t * to; }
};

// Two bands across each other, so that it is seen from everywhere.
void add_wood(TreeModel& tree, const Curve& curve, int parts, float thick, float left, float other,
              float light) {
    for (int k = 0; k < parts; ++k) {
        const float t = static_cast<float>(k) / static_cast<float>(parts),
                    next = static_cast<float>(k + 1) / static_cast<float>(parts);
        const glm::vec3 a = curve.at(t), b = curve.at(next), along = b - a;
        glm::vec3 aside = glm::cross(along, kUpward);
        aside = glm::dot(aside, aside) > 1e-9f ? glm::normalize(aside) : glm::vec3(1, 0, 0);
        const glm::vec3 over = glm::normalize(glm::cross(aside, along));
        const float wide = thick * glm::mix(1.f, left, t), narrow = thick * glm::mix(1.f, left, next);
        for (const glm::vec3 way : {aside, over}) {
            tree.push_back({a - wide * way, a + wide * way, b + narrow * way, over, other, light});
            tree.push_back({a - wide * way, b + narrow * way, b - narrow * way, over, other, light});
        }
    }
}

void add_stem(TreeModel& tree, const Habit& habit, float other) {
    constexpr int kSides = 6, kParts = 3;
    const auto radius = [&](float z) { return habit.stem * (1 - 0.75f * z / habit.stem_top); };
    for (int k = 0; k < kParts; ++k)
        for (int i = 0; i < kSides; ++i) {
            const float low = k == 0 ? -0.03f : habit.stem_top * static_cast<float>(k) / kParts,
                        high = habit.stem_top * static_cast<float>(k + 1) / kParts;
            const glm::vec3 from = direction(static_cast<float>(i) / kSides),
                            to = direction(static_cast<float>(i + 1) / kSides);
            const glm::vec3 a = radius(low) * from + low * kUpward, b = radius(low) * to + low * kUpward,
                            c = radius(high) * from + high * kUpward, d = radius(high) * to + high * kUpward;
            const float light = 0.75f - 0.35f * ramp(habit.base - 0.1f, habit.base + 0.15f, high);
            tree.push_back({a, b, d, from, other, light});
            tree.push_back({a, d, c, from, other, light});
        }
}

// A cloud of leaves: sprays that lie on it like tiles, dark below and toward the middle of the crown.
void add_cloud(TreeModel& tree, const Habit& habit, glm::vec3 middle, float radius, Chance& chance) {
    const float own = chance(0.74f, 1.12f);
    const glm::vec3 heart(0, 0, glm::mix(habit.base, 1.f, 0.35f));
    for (int k = 0; k < habit.sprays; ++k) {
        glm::vec3 out = any_direction(chance);
        const bool hangs = chance() < habit.hanging;
        const float reach = radius * chance(0.62f, 1.12f);
        glm::vec3 at = middle + reach * glm::vec3(out.x, out.y, (hangs ? 0.4f : 0.78f) * out.z);
        if (hangs) at.z -= radius * chance(0.3f, 1.7f);
        if (at.z < 0.02f || at.z > 1.005f) continue;
        const glm::vec3 crown_out = glm::normalize(at - heart);
        const glm::vec3 normal = glm::normalize(0.75f * out + 0.75f * crown_out + 0.25f * kUpward);
        // A spray is a rhomb. It faces out, with much disorder, and its tip is lower than its foot.
        const glm::vec3 random = any_direction(chance);
        const glm::vec3 face = glm::normalize(out + 0.35f * kUpward + 0.8f * random);
        const glm::vec3 other_way = any_direction(chance);
        glm::vec3 along = glm::cross(face, other_way + 0.01f * kUpward);
        along = glm::normalize(glm::normalize(along + 1e-4f * out) - (hangs ? 1.6f : 0.25f) * kUpward);
        const glm::vec3 aside = glm::normalize(glm::cross(along, face) + 1e-4f * kUpward);
        const float length = habit.spray * chance(0.6f, 1.35f), wide = (hangs ? 0.30f : 0.62f) * length;
        const glm::vec3 a = at - length * along, b = at + length * along,
                        c = at + wide * aside - 0.2f * length * along,
                        d = at - wide * aside - 0.2f * length * along;
        const float outer = glm::length(glm::vec2(at)) / std::max(crown_at(habit, at.z), 0.3f * habit.radius);
        const float open = std::max(ramp(0.35f, 1.0f, outer), ramp(0.80f, 1.0f, at.z));
        const float light = own * chance(0.80f, 1.15f) * (0.30f + 0.70f * ramp(-0.80f, 0.70f, out.z)) *
                            glm::mix(habit.light_inside, 1.f, open) *
                            (0.72f + 0.28f * ramp(habit.base, 0.7f, at.z));
        tree.push_back({a, c, b, normal, 0, light});
        tree.push_back({a, b, d, normal, 0, light});
    }
}

// Branches of a limb without leaves, with their twigs.
void add_branches(TreeModel& tree, const Habit& habit, const Curve& limb, Chance& chance) {
    constexpr int kBranches = 8, kTwigs = 7;
    const glm::vec3 way = glm::normalize(limb.to - limb.from);
    for (int k = 0; k < kBranches; ++k) {
        const float t = 0.30f + 0.70f * (static_cast<float>(k) + chance()) / kBranches;
        const glm::vec3 from = limb.at(t), random = any_direction(chance);
        const glm::vec3 out = glm::normalize(0.6f * way + 0.95f * random + 0.30f * kUpward);
        const float length = habit.cloud * chance(0.8f, 1.6f);
        const Curve branch{from, from + 0.5f * length * out,
                           from + length * glm::normalize(out + 0.5f * kUpward)};
        if (branch.to.z > 0.98f) continue;
        const float light = chance(0.7f, 0.95f);
        add_wood(tree, branch, 2, 0.0030f, 0.5f, chance() < 0.35f ? 0.55f : 0.f, light);
        for (int i = 0; i < kTwigs; ++i) {
            const glm::vec3 foot = branch.at(0.2f + 0.8f * (static_cast<float>(i) + chance()) / kTwigs);
            const glm::vec3 other_random = any_direction(chance);
            const glm::vec3 twig = glm::normalize(0.7f * out + 0.85f * other_random + 0.30f * kUpward);
            const glm::vec3 tip = foot + length * chance(0.35f, 0.75f) * twig;
            if (tip.z > 1.005f) continue;
            const glm::vec3 aside =
                0.0023f * glm::normalize(glm::cross(twig, other_random) + 1e-4f * kUpward);
            tree.push_back({foot - aside, foot + aside, tip, glm::normalize(out + kUpward),
                            chance() < 0.25f ? 0.5f : 0.f, chance(0.8f, 1.05f)});
        }
    }
}

// Snow that lies along the upper half of a limb.
void add_snow(TreeModel& tree, const Curve& limb, float thick, Chance& chance) {
    if (chance() < 0.4f) return;
    constexpr int kParts = 4;
    for (int k = 1; k < kParts; ++k) {
        if (chance() < 0.2f) continue;
        const glm::vec3 a = limb.at(static_cast<float>(k) / kParts),
                        b = limb.at(static_cast<float>(k + 1) / kParts);
        const glm::vec3 high = 1.6f * thick * kUpward,
                        aside = glm::normalize(glm::cross(b - a, kUpward) + 1e-4f * direction(0));
        tree.push_back(
            {a + 0.5f * high - thick * aside, b + 0.5f * high + thick * aside, a + high, kUpward, 1, 1});
        tree.push_back(
            {b + 0.5f * high - thick * aside, a + 0.5f * high + thick * aside, b + high, kUpward, 1, 1});
    }
}

TreeModel grown(const Habit& habit, std::uint32_t seed, Foliage foliage) {
    Chance chance(seed);
    TreeModel tree;
    const bool bare = foliage == Foliage::kBare;
    const float bark = bare ? 0.f : 1.f;  // as a bare tree's `other` is snow
    if (habit.stem > 0) add_stem(tree, habit, bark);
    float turns = chance();
    for (int i = 0; i < habit.limbs; ++i) {
        const float u = (static_cast<float>(i) + chance()) / static_cast<float>(habit.limbs);
        const float z = glm::mix(habit.base + 0.6f * habit.cloud, 1 - 0.85f * habit.cloud, u);
        turns += kGoldenTurn + chance(-0.06f, 0.06f);
        const bool inner = i % 4 == 3;  // else the crown would be hollow
        const float cloud = habit.cloud * chance(0.70f, 1.25f) * (1 - 0.35f * ramp(0.6f, 1.0f, u));
        const float most = std::max(crown_at(habit, z) - 0.8f * cloud, 0.f);
        const float reach = most * (inner ? chance(0.1f, 0.5f) : chance(0.72f, 1.06f));
        const glm::vec3 to = reach * direction(turns) + z * kUpward;
        const float foot =
            habit.stem > 0 ? std::clamp(z - 0.10f - 0.75f * reach, 0.75f * habit.base, 0.80f) : 0.f;
        const Curve limb{foot * kUpward,
                         0.62f * reach * direction(turns) + glm::mix(foot, z, 0.40f) * kUpward, to};
        const float thick = 0.0105f * (0.35f + reach / habit.radius) * (1 - 0.5f * foot);
        add_wood(tree, limb, 5, thick, 0.25f, bark, bare ? 0.8f : 0.45f);
        if (bare) {
            add_branches(tree, habit, limb, chance);
            add_snow(tree, limb, 0.7f * thick, chance);
            continue;
        }
        add_cloud(tree, habit, to, cloud, chance);
        if (chance() < 0.5f)
            add_cloud(tree, habit, limb.at(0.72f) + 0.5f * cloud * kUpward, 0.8f * cloud, chance);
    }
    return tree;
}

}  // namespace

TreeModel grow_beech(std::uint32_t seed, float slender, Foliage foliage) {
    const Habit habit{.radius = kBeechRadius * glm::mix(1.f, 0.86f, slender),
                      .base = glm::mix(0.10f, 0.27f, slender),
                      .widest = glm::mix(0.40f, 0.50f, slender),
                      .pointed = 0.10f,
                      .stem = 0.020f,
                      .stem_top = 0.72f,
                      .limbs = foliage == Foliage::kBare ? 26 : 34,
                      .cloud = 0.102f,
                      .sprays = 175,
                      .spray = 0.0122f,
                      .hanging = 0.04f,
                      .light_inside = 0.34f};
    return grown(habit, seed, foliage);
}

TreeModel grow_birch(std::uint32_t seed) {
    const Habit habit{.radius = kBirchRadius,
                      .base = 0.20f,
                      .widest = 0.34f,
                      .pointed = 0.55f,
                      .stem = 0.013f,
                      .stem_top = 0.92f,
                      .limbs = 34,
                      .cloud = 0.064f,
                      .sprays = 70,
                      .spray = 0.0135f,
                      .hanging = 0.40f,
                      .light_inside = 0.62f};
    return grown(habit, seed, Foliage::kLeaves);
}

TreeModel grow_bush(std::uint32_t seed) {
    const Habit habit{.radius = kBushRadius,
                      .base = 0.02f,
                      .widest = 0.36f,
                      .pointed = 0,
                      .stem = 0,
                      .stem_top = 0,
                      .limbs = 34,
                      .cloud = 0.17f,
                      .sprays = 170,
                      .spray = 0.027f,
                      .hanging = 0.05f,
                      .light_inside = 0.50f};
    return grown(habit, seed, Foliage::kLeaves);
}

TreeModel grow_broad_leaved_group(std::uint32_t seed, Foliage foliage) {
    Chance chance(seed);
    TreeModel group;
    constexpr int kTrees = 11;
    const std::array<TreeModel, 2> kinds{grow_beech(seed + 1, 0.0f, foliage),
                                         grow_beech(seed + 2, 0.35f, foliage)};
    for (int i = 0; i < kTrees; ++i) {
        const float x = glm::mix(-0.72f, 0.72f, (static_cast<float>(i) + chance(0.2f, 0.8f)) / kTrees),
                    y = chance(-0.35f, 0.35f);
        // Lower at the ends, so that it goes over into the next one.
        const float high = chance(0.60f, 1.0f) * (1 - 0.35f * x * x);
        const float bright = chance(0.82f, 1.12f);
        add_tree(group, kinds[static_cast<std::size_t>(i) % 2], {x, y, high, high, bright},
                 {0.70f, 0.45f, 0.15f, 0.75f});
    }
    return group;
}

}  // namespace render
