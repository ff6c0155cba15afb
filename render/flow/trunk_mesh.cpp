#include "render/flow/trunk_mesh.h"

#include <cmath>

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

#include "render/base/chance.h"

namespace render {
namespace {

constexpr float kBrokenTop = 0.45f;               // diameter where it broke, of that at the root
constexpr float kPlate = 2.1f, kPlateFar = 1.5f;  // radius of its roots, diameters; of the soil on them
constexpr float kStubLength = 1.6f;               // length of a branch's stub, diameters

class TrunkBuilder {
  public:
    void triangle(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c, TrunkPart part) {
        // Of one length: a trunk is some 26 diameters long, which normals must know.
        constexpr float kLong = 26;
        const glm::vec3 stretch(kLong, 1, 1);
        const glm::vec3 facing = glm::normalize(glm::cross(stretch * (b - a), stretch * (c - a)));
        for (const glm::vec3& at : {a, b, c}) corners.push_back({at, facing, part});
    }
    void quad(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c, const glm::vec3& d,
              TrunkPart part) {
        triangle(a, b, c, part);
        triangle(a, c, d, part);
    }
    std::vector<TrunkCorner> corners;
};

glm::vec3 on_ring(float along, float radius, float turns) {
    const glm::vec3 way = radius * direction(turns);
    return {along, way.x, way.y};
}

void add_stem(TrunkBuilder& to, int sides, int rings) {
    for (int k = 0; k < rings; ++k)
        for (int i = 0; i < sides; ++i) {
            const float s = static_cast<float>(k) / static_cast<float>(rings),
                        e = static_cast<float>(k + 1) / static_cast<float>(rings);
            const float a = static_cast<float>(i) / static_cast<float>(sides),
                        b = static_cast<float>(i + 1) / static_cast<float>(sides);
            const float near = 0.5f * (1 + s * (kBrokenTop - 1)), far = 0.5f * (1 + e * (kBrokenTop - 1));
            to.quad(on_ring(s - 0.5f, near, a), on_ring(s - 0.5f, near, b), on_ring(e - 0.5f, far, b),
                    on_ring(e - 0.5f, far, a), TrunkPart::kBark);
        }
}

// Where it broke: splinters of fresh wood.
void add_break(TrunkBuilder& to, int sides, Chance& chance) {
    const glm::vec3 tip(0.5f + 0.03f, 0.1f, 0.05f);
    for (int i = 0; i < sides; ++i) {
        const float a = static_cast<float>(i) / static_cast<float>(sides),
                    b = static_cast<float>(i + 1) / static_cast<float>(sides);
        const glm::vec3 splinter = on_ring(0.5f + chance(0.01f, 0.06f), 0.3f * kBrokenTop, 0.5f * (a + b));
        to.triangle(on_ring(0.5f, 0.5f * kBrokenTop, a), on_ring(0.5f, 0.5f * kBrokenTop, b), splinter,
                    TrunkPart::kWood);
        to.triangle(splinter, tip, on_ring(0.5f, 0.5f * kBrokenTop, a), TrunkPart::kWood);
    }
}

// The plate stands across the root, thicker in its middle, with roots that stick out of it.
void add_roots(TrunkBuilder& to, int sides, Chance& chance) {
    constexpr float kThick = 0.03f;  // lengths
    const glm::vec3 before(-0.5f + 1.2f * kThick, 0, 0), behind(-0.5f - kThick, 0, 0);
    for (int i = 0; i < sides; ++i) {
        const float a = static_cast<float>(i) / static_cast<float>(sides),
                    b = static_cast<float>(i + 1) / static_cast<float>(sides), middle = 0.5f * (a + b);
        const glm::vec3 root = on_ring(-0.5f + chance(-0.03f, 0.02f), chance(0.85f, 1.35f) * kPlate, middle);
        const glm::vec3 left = on_ring(-0.5f, chance(0.55f, 1) * kPlateFar, a),
                        right = on_ring(-0.5f, kPlateFar * chance(0.55f, 1), b);
        to.triangle(before, left, root, TrunkPart::kRoots);
        to.triangle(before, root, right, TrunkPart::kRoots);
        to.triangle(behind, root, left, TrunkPart::kRoots);
        to.triangle(behind, right, root, TrunkPart::kRoots);
    }
}

void add_stubs(TrunkBuilder& to, Chance& chance) {
    constexpr int kStubs = 9;
    for (int i = 0; i < kStubs; ++i) {
        const float along = -0.1f + 0.6f * (static_cast<float>(i) + chance(0, 0.8f)) / kStubs,
                    turns = chance();
        const float radius = 0.5f * (1 + (along + 0.5f) * (kBrokenTop - 1)),
                    long_by = kStubLength * chance(0.4f, 1);
        const glm::vec3 tip = on_ring(along + 0.02f, radius + long_by, turns);
        const glm::vec3 a = on_ring(along - 0.004f, 0.9f * radius, turns - 0.05f),
                        b = on_ring(along - 0.004f, 0.9f * radius, turns + 0.05f),
                        c = on_ring(along + 0.006f, 0.9f * radius, turns);
        to.triangle(a, b, tip, TrunkPart::kBark);
        to.triangle(b, c, tip, TrunkPart::kBark);
        to.triangle(c, a, tip, TrunkPart::kBark);
    }
}

}  // namespace

std::array<std::vector<TrunkCorner>, kTrunkLevels> trunk_mesh() {
    std::array<std::vector<TrunkCorner>, kTrunkLevels> levels;
    for (std::size_t i = 0; i < levels.size(); ++i) {
        TrunkBuilder builder;
        builder.corners.reserve(600);
        Chance chance(17);
        const int sides = i == 0 ? 8 : 4;
        add_stem(builder, sides, i == 0 ? 2 : 1);
        add_break(builder, sides, chance);
        add_roots(builder, i == 0 ? 11 : 5, chance);
        if (i == 0) add_stubs(builder, chance);
        levels[i] = std::move(builder.corners);
    }
    return levels;
}

}  // namespace render
