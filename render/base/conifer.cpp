#include "render/base/conifer.h"

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

constexpr glm::vec3 kUp{0, 0, 1};

// x to a power between a half and 1.
float rooted(float x, float power) {
    return glm::mix(std::sqrt(x), x, 2 * power - 1);
}

void add_stem(TreeModel& tree, float radius, float top, float light, float other = 0) {
    constexpr int kSides = 5;
    for (int i = 0; i < kSides; ++i) {
        const glm::vec3 from = direction(static_cast<float>(i) / kSides),
                        to = direction(static_cast<float>(i + 1) / kSides);
        const float left = std::max(1 - top, 0.f);  // of its radius, where it ends
        const glm::vec3 a = radius * from - 0.03f * kUp, b = radius * to - 0.03f * kUp;
        const glm::vec3 c = radius * left * from + top * kUp, d = radius * left * to + top * kUp;
        tree.push_back({a, b, d, from, other, light});
        tree.push_back({a, d, c, from, other, light});
    }
}

// A branch of a spruce or a larch. Its curve rises, droops and lifts at its tip.
struct Branch {
    float foot;   // height on the stem
    float turns;  // direction
    float length;
    float rise, droop, lift;
    float width;           // of its twigs, of its length
    float crown;           // radius of the crown here
    int twigs;             // on either side
    float thick, needles;  // half the width of the branch, of a twig
    float snowy;           // share of its kind that carry snow
    float frosted;         // share of the twigs that are white with rime

    glm::vec3 out() const { return direction(turns); }
    glm::vec3 aside() const { return {-out().y, out().x, 0}; }
    glm::vec3 at(float t) const {
        return foot * kUp + out() * (length * t * (1 - 0.10f * t)) +
               kUp * (length * (rise * t - droop * t * t + lift * t * t * t));
    }
    // Inner parts get less light.
    float light(glm::vec3 place) const {
        return 0.22f + 0.78f * ramp(0.15f, 1.0f, glm::length(glm::vec2(place)) / crown);
    }
};

void add_wood(TreeModel& tree, const Branch& branch, float other = 0) {
    constexpr int kParts = 4;
    for (int k = 0; k < kParts; ++k) {
        const glm::vec3 from = branch.at(static_cast<float>(k) / kParts),
                        to = branch.at(static_cast<float>(k + 1) / kParts);
        tree.push_back({from - branch.thick * kUp, from + branch.thick * kUp, to,
                        glm::normalize(branch.out() + kUp), other, 0.7f * branch.light(from)});
    }
}

void add_twigs(TreeModel& tree, const Branch& branch, Chance& chance) {
    const glm::vec3 out = branch.out();
    const float own = chance(0.8f, 1.15f);
    for (int k = 0; k < branch.twigs; ++k)
        for (const glm::vec3 aside : {-branch.aside(), branch.aside()}) {
            const float t =
                0.10f + 0.90f * (static_cast<float>(k) + chance(0, 0.8f)) / static_cast<float>(branch.twigs);
            const glm::vec3 from = branch.at(t);
            const float length =
                branch.length * branch.width * (0.30f + 0.95f * rooted(1 - t, 0.7f)) * chance(0.7f, 1.2f);
            const float spread = chance(0.45f, 1.0f), hang = chance(0.15f, 0.75f);
            const glm::vec3 tip = from + length * glm::normalize(0.8f * out + spread * aside - hang * kUp);
            const float wide = branch.needles * chance(0.7f, 1.3f);
            const float light = own * branch.light(glm::mix(from, tip, 0.6f)) * chance(0.75f, 1.2f);
            const glm::vec3 normal = glm::normalize(0.75f * out + 0.35f * aside + 0.55f * kUp);
            const float white = chance() < branch.frosted ? 0.45f : 0.f;
            // One lies flat and one hangs, so that a twig is seen from everywhere.
            tree.push_back({from - wide * out, from + wide * out, tip, normal, white, light});
            tree.push_back({from - 1.3f * wide * kUp + 0.3f * (tip - from), from + 0.5f * wide * kUp,
                            tip - 0.6f * wide * kUp, normal, 0.4f * white, 0.8f * light});
        }
}

// A roof of snow along a branch, in pieces.
void add_snow(TreeModel& tree, const Branch& branch, Chance& chance) {
    if (chance() > branch.snowy) return;
    const glm::vec3 out = branch.out();
    const float first = chance(0.12f, 0.40f), last = chance(0.72f, 1.02f);
    constexpr int kPieces = 5;
    float before = 0.2f;  // width of the piece, relative
    for (int k = 0; k < kPieces; ++k) {
        const float now = k + 1 == kPieces ? 0.1f : chance(0.35f, 1.15f),
                    half = 0.62f * branch.length * branch.width;
        const float from_half = before * half, to_half = now * half, high = 0.010f * (0.5f + now);
        before = now;
        if (chance() < 0.13f) continue;  // fallen
        const glm::vec3 from =
                            branch.at(glm::mix(first, last, static_cast<float>(k) / kPieces)) + 0.004f * kUp,
                        to = branch.at(glm::mix(first, last, static_cast<float>(k + 1) / kPieces)) +
                             0.004f * kUp;
        const float light = (0.55f + 0.45f * branch.light(to)) * chance(0.9f, 1.05f);
        for (const glm::vec3 aside : {-branch.aside(), branch.aside()}) {
            const glm::vec3 eave = aside - 0.30f * kUp;
            const glm::vec3 normal = glm::normalize(kUp + 0.35f * out + 0.35f * aside);
            tree.push_back(
                {from + from_half * eave, to + to_half * eave, from + high * kUp, normal, 1, light});
            tree.push_back({to + to_half * eave, to + high * kUp, from + high * kUp, normal, 1, light});
        }
    }
}

void add_branch(TreeModel& tree, const Branch& branch, Chance& chance) {
    add_wood(tree, branch);
    add_twigs(tree, branch, chance);
    add_snow(tree, branch, chance);
}

}  // namespace

TreeModel grow_spruce(std::uint32_t seed, float snowy, float top) {
    Chance chance(seed);
    TreeModel tree;
    add_stem(tree, 0.014f, std::min(top, 0.97f), 0.35f);
    const float slim = chance(0.85f, 1.1f), bulge = chance(0.72f, 0.95f), bare = chance(0.03f, 0.09f);
    const int whorls = 24 + static_cast<int>(chance(0, 6));
    float turns = chance();
    for (int i = 0; i < whorls; ++i) {
        const float up = (static_cast<float>(i) + 0.2f) / static_cast<float>(whorls);
        const float crown = kConiferRadius * 1.03f * slim * rooted(1 - up, bulge) *
                                (0.78f + 0.22f * ramp(-0.05f, 0.15f, up)) +
                            0.006f;
        const float whorl = chance(0.82f, 1.12f);
        const int branches = up > 0.9f ? 4 : up > 0.6f ? 6 : 8;
        for (int k = 0; k < branches; ++k) {
            turns += 1 / static_cast<float>(branches) + chance(-0.04f, 0.04f);
            // Without some disorder whorls would be stripes.
            const float foot = bare + (0.985f - bare) * up + chance(-0.4f, 0.4f) / static_cast<float>(whorls);
            const bool is_short = chance() < 0.12f;
            const float length = crown * whorl * (is_short ? chance(0.5f, 0.8f) : chance(0.86f, 1.14f));
            if (chance() < 0.06f || foot > top) continue;
            add_branch(tree,
                       {.foot = foot,
                        .turns = turns,
                        .length = length,
                        .rise = glm::mix(-0.15f, 0.95f, up * up),
                        .droop = glm::mix(0.55f, 0.35f, up),
                        .lift = 0.22f,
                        .width = 0.34f,
                        .crown = crown,
                        .twigs = up > 0.8f ? 5 : 9,
                        .thick = 0.003f,
                        .needles = glm::mix(0.0075f, 0.0045f, up),
                        .snowy = snowy,
                        .frosted = 0.25f * snowy},
                       chance);
        }
        turns += 0.175f;
    }
    // Its leader, or what is left of the stem.
    if (top < 1)
        for (int k = 0; k < 3; ++k) {
            const glm::vec3 side = 0.006f * direction(static_cast<float>(k) / 3);
            tree.push_back({(top - 0.02f) * kUp - side, (top - 0.02f) * kUp + side,
                            (top + 0.05f) * kUp + 0.5f * side, direction(0.75f), 0, 0.8f});
        }
    else
        tree.push_back(
            {{-0.004f, 0, 0.95f}, {0.004f, 0, 0.95f}, kUp, {0, -0.5f, 0.866f}, 0.3f * snowy, 0.9f});
    return tree;
}

TreeModel grow_larch(std::uint32_t seed) {
    Chance chance(seed);
    TreeModel tree;
    add_stem(tree, 0.0095f, 0.99f, 0.75f);
    float turns = 0;
    constexpr int kWhorls = 22, kBranches = 4;
    for (int i = 0; i < kWhorls; ++i) {
        const float up = (static_cast<float>(i) + chance()) / kWhorls;
        const float crown = kConiferRadius * rooted(1 - up, 0.75f) + 0.012f;
        for (int k = 0; k < kBranches; ++k) {
            turns += 1.0f / kBranches + chance(-0.07f, 0.07f);
            add_branch(tree,
                       {.foot = 0.10f + 0.88f * up + chance(-0.02f, 0.02f),
                        .turns = turns,
                        .length = crown * chance(0.6f, 1.15f),
                        .rise = glm::mix(0.05f, 0.6f, up),
                        .droop = 0.25f,
                        .lift = 0.25f,
                        .width = 0.30f,
                        .crown = 0.45f * crown,
                        .twigs = 7,
                        .thick = 0.0026f,
                        .needles = 0.0024f,
                        .snowy = 0.25f,
                        .frosted = 0.22f},
                       chance);
        }
        turns += 0.11f;
    }
    return tree;
}

TreeModel grow_green_larch(std::uint32_t seed) {
    Chance chance(seed);
    TreeModel tree;
    add_stem(tree, 0.0115f, 0.97f, 0.55f, 1);
    float turns = 0;
    constexpr int kWhorls = 26, kBranches = 5;
    for (int i = 0; i < kWhorls; ++i) {
        const float up = (static_cast<float>(i) + chance()) / kWhorls;
        const float crown = kConiferRadius * rooted(1 - up, 0.78f) + 0.012f;
        for (int k = 0; k < kBranches; ++k) {
            turns += 1.0f / kBranches + chance(-0.07f, 0.07f);
            const Branch branch{.foot = 0.10f + 0.88f * up + chance(-0.02f, 0.02f),
                                .turns = turns,
                                .length = crown * chance(0.55f, 1.12f),
                                .rise = glm::mix(0.0f, 0.7f, up),
                                .droop = 0.30f,
                                .lift = 0.28f,
                                .width = 0.30f,
                                .crown = crown,
                                .twigs = 8,
                                .thick = 0.0026f,
                                .needles = 0.0052f,
                                .snowy = 0,
                                .frosted = 0};
            add_wood(tree, branch, 1);
            add_twigs(tree, branch, chance);
        }
        turns += 0.11f;
    }
    return tree;
}

TreeModel grow_dwarf_pine(std::uint32_t seed) {
    Chance chance(seed);
    TreeModel tree;
    constexpr int kTufts = 170, kNeedles = 40, kSides = 9;
    for (int i = 0; i < kTufts; ++i) {
        const glm::vec3 way = direction(chance());
        const float r = kCushionRadius * std::sqrt(chance());
        const float dome = std::sqrt(std::max(1 - r * r / 0.70f, 0.02f)) * chance(0.55f, 0.98f);
        const glm::vec3 at = r * way + dome * chance(0.6f, 0.8f) * kUp;
        const glm::vec3 out = glm::normalize(glm::vec3(at.x, at.y, 0.55f + 0.3f * at.z));
        const float size = chance(0.13f, 0.22f), light = 0.30f + 0.70f * ramp(0.0f, 0.85f, glm::length(at));
        for (int k = 0; k < kNeedles; ++k) {
            const float x = chance(-1, 1), y = chance(-1, 1), z = chance(-0.8f, 1);
            const glm::vec3 along = glm::normalize(0.9f * out + glm::vec3(x, y, z));
            const float u = chance(-1, 1), v = chance(-1, 1);
            const glm::vec3 wide = 0.022f * glm::normalize(glm::cross(along, glm::vec3(u, v, 0.3f)));
            const float white = along.z > 0.75f && chance() < 0.3f ? 0.5f : 0.f;
            tree.push_back({at - wide, at + wide, at + size * along, glm::normalize(along + 0.7f * out),
                            white, light * chance(0.6f, 1.2f)});
        }
        if (chance() > 0.5f || at.z < 0.25f) continue;
        // A cap of snow: flat, ragged at its rim.
        std::array<glm::vec3, kSides> rim;
        for (int k = 0; k < kSides; ++k) {
            const float wide = size * chance(0.35f, 0.85f), high = size * chance(0.20f, 0.42f);
            rim[static_cast<std::size_t>(k)] =
                at + wide * direction(static_cast<float>(k) / kSides) + high * kUp;
        }
        const float bright = chance(0.85f, 1.0f);
        for (int k = 0; k < kSides; ++k) {
            const glm::vec3 side = direction((static_cast<float>(k) + 0.5f) / kSides);
            tree.push_back({rim[static_cast<std::size_t>(k)], rim[static_cast<std::size_t>((k + 1) % kSides)],
                            at + 0.62f * size * kUp, glm::normalize(0.5f * side + kUp), 1, bright});
        }
    }
    return tree;
}

TreeModel grow_group(std::uint32_t seed) {
    Chance chance(seed);
    TreeModel group;
    constexpr int kTrees = 12;
    const std::array<TreeModel, 2> kinds{grow_spruce(seed + 1, 0.68f), grow_spruce(seed + 2, 0.45f)};
    for (int i = 0; i < kTrees; ++i) {
        const float x = glm::mix(-0.82f, 0.82f, (static_cast<float>(i) + chance()) / kTrees),
                    y = chance(-0.35f, 0.35f);
        // Lower at the ends, so that it goes over into the next one.
        const float high = chance(0.5f, 1.0f) * (1 - 0.3f * x * x), wide = 1.4f * std::min(high + 0.1f, 1.f);
        const float bright = chance(0.8f, 1.15f);
        add_tree(group, kinds[static_cast<std::size_t>(i) % 2], {x, y, wide, high, bright},
                 {0.85f, 0.35f, 0.1f, 0.7f});
    }
    return group;
}

}  // namespace render
