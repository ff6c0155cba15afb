#include "render/flow/carried_in_view.h"

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "render/base/ramp.h"
#include "sim/carried/trunk.h"

namespace render {
namespace {

constexpr float kLeastOfTrunk = 5,
                kFineTrunk = 70;             // pixels of length, below which it is not drawn, or coarse
constexpr std::size_t kReserved = 60'000;    // vertices, for what is coarse
constexpr float kLeastPixels = 1.1f;         // diameter; a smaller body is not drawn
constexpr std::array kFrom{26.f, 9.f, 0.f};  // pixels of diameter, from which on each level is drawn
constexpr float kMostPerHeight = 5;          // length of a shadow, of the height of what casts it

glm::vec3 rotated(const glm::vec4& q, const glm::vec3& v) {
    const glm::vec3 axis(q), across = 2.f * glm::cross(axis, v);
    return v + q.w * across + glm::cross(axis, across);
}

// Where shadows point, and how long they are.
struct Shade {
    explicit Shade(const FrameBlock& frame) {
        const glm::vec2 sun(frame.sun);
        const float flat = std::max(glm::length(sun), 1e-3f);
        away = -sun / flat;
        per_height = std::min(flat / std::max(frame.sun.z, 0.05f), kMostPerHeight);
    }
    glm::vec2 away;
    float per_height;
};

// Height of a body above the surface, m.
float height_of(const sim::carried::Body& body) {
    return (1 - body.sunk) *
           (body.kind == sim::carried::Kind::kTrunk ? sim::carried::thickness_of(body) : body.size);
}
float along(const sim::carried::Body& body, const Shade& shade) {
    return shade.per_height * height_of(body);
}
float beside(const sim::carried::Body& body) {
    return 0.8f * body.size + 0.3f;
}

int level_of(float pixels) {
    int level = 0;
    while (pixels < kFrom[static_cast<std::size_t>(level)]) ++level;
    return level;
}

}  // namespace

float CarriedInView::reach(const sim::carried::Body& body, const FrameBlock& frame) {
    return beside(body) + along(body, Shade(frame));
}

void CarriedInView::reserve() {
    bodies_.reserve(sim::carried::Carried::kMost);
    vertices_.reserve(kMostVertices);
    shadows_.reserve(6 * sim::carried::Carried::kMost);
}

void CarriedInView::find(std::span<const sim::carried::Body> bodies, const FrameBlock& frame,
                         const OnScreen& screen) {
    bodies_.clear(), vertices_.clear(), shadows_.clear();
    const glm::vec3 eye(frame.eye);
    const Shade shade(frame);
    const float pixel = frame.material.y * frame.material.z;  // m at a distance of 1 m
    for (std::size_t i = 0; i < bodies.size(); ++i) {
        const sim::carried::Body& body = bodies[i];
        const float pixels = body.size / (std::max(glm::distance(body.at, eye), 0.1f) * pixel);
        const bool is_trunk = body.kind == sim::carried::Kind::kTrunk;
        if (pixels < (is_trunk ? kLeastOfTrunk : kLeastPixels) || body.sunk > 0.97f) continue;
        const glm::vec3 tip = body.at + glm::vec3(along(body, shade) * shade.away, 0);
        const Rectangle seen =
            screen.box(glm::min(body.at, tip) - beside(body), glm::max(body.at, tip) + beside(body));
        if (seen.empty()) continue;
        InView in_view{i, seen, static_cast<std::uint32_t>(vertices_.size()), 0,
                       static_cast<std::uint32_t>(shadows_.size())};
        if (is_trunk)
            add_trunk(body, pixels);
        else
            add_boulder(body, pixels);
        in_view.count = static_cast<std::uint32_t>(vertices_.size()) - in_view.first;
        add_shadow(body, shade.away, along(body, shade));
        bodies_.push_back(in_view);
    }
}

void CarriedInView::add_boulder(const sim::carried::Body& body, float pixels) {
    const RockMesh& rock = rocks_[static_cast<std::size_t>(sim::carried::own(body, 5) * kRocks)];
    const bool is_crowded = vertices_.size() + rock[0].size() + kReserved > kMostVertices;
    const auto& corners = is_crowded ? rock.back() : rock[static_cast<std::size_t>(level_of(pixels))];
    const float surface = body.at.z - (0.5f - body.sunk) * body.size, tone = sim::carried::own(body, 6);
    for (const RockCorner& corner : corners) {
        const glm::vec3 at = body.at + rotated(body.turn, body.size * corner.at);
        const glm::vec3 facing = rotated(body.turn, corner.facing);
        const float height = (at.z - surface) / body.size;
        const float open = (0.62f + 0.38f * facing.z) * (0.35f + 0.65f * ramp(-0.05f, 0.45f, height));
        vertices_.push_back(
            {{at, tone}, {facing, std::clamp(open, 0.f, 1.f)}, {body.size * corner.at, height}});
    }
}

// Mud covers it as far up as it is sunk, and all of its roots.
void CarriedInView::add_trunk(const sim::carried::Body& body, float pixels) {
    const bool is_crowded = vertices_.size() + trunk_[0].size() + kReserved > kMostVertices;
    const auto& corners = trunk_[is_crowded || pixels < kFineTrunk];
    const float thick = sim::carried::thickness_of(body), tone = 0.99f * sim::carried::own(body, 9);
    const glm::vec3 axis(body.turn), side = glm::normalize(glm::cross(glm::vec3(0, 0, 1), axis)),
                                     up = glm::cross(axis, side);
    const float turn = 6.2832f * sim::carried::own(body, 10), c = std::cos(turn), s = std::sin(turn);
    const glm::vec3 y = c * side + s * up, z = c * up - s * side;
    const auto placed = [&](const glm::vec3& of, float along, float across) {
        return along * of.x * axis + across * (of.y * y + of.z * z);
    };
    for (const TrunkCorner& corner : corners) {
        const glm::vec3 from = placed(corner.at, body.size, thick), facing = placed(corner.facing, 1, 1);
        const float height = 0.5f - body.sunk + (from.z - axis.z * corner.at.x * body.size) / thick;
        const float open = (0.62f + 0.38f * facing.z) * (0.45f + 0.55f * ramp(-0.3f, 0.8f, height));
        vertices_.push_back({{body.at + from, tone + 1 + static_cast<float>(corner.part)},
                             {facing, std::clamp(open, 0.f, 1.f)},
                             {body.size * corner.at.x, thick * corner.at.y, thick * corner.at.z, height}});
    }
}

// Around the body's foot, where no sky is seen, and on to the shadow of its top.
void CarriedInView::add_shadow(const sim::carried::Body& body, glm::vec2 away, float along) {
    const glm::vec2 foot = glm::vec2(body.at) + 0.5f * along * away;
    glm::vec2 long_axis = away;
    float half = 0.72f * body.size, reach = 0.75f * body.size + 0.5f * along;
    if (body.kind == sim::carried::Kind::kTrunk) {
        long_axis = glm::normalize(glm::vec2(body.turn));
        half = 1.1f * sim::carried::thickness_of(body) + 0.5f * along, reach = 0.56f * body.size;
    }
    const glm::vec2 aside(-long_axis.y, long_axis.x);
    const float strength = 0.9f * ramp(1.f, 0.6f, body.sunk);
    const auto corner = [&](float u, float v) {
        const glm::vec2 at = foot + u * reach * long_axis + v * half * aside;
        return CarriedShadowVertex{{at, u, v}, {body.at, strength}};
    };
    const CarriedShadowVertex a = corner(-1, -1), b = corner(1, -1), c = corner(1, 1), d = corner(-1, 1);
    for (const CarriedShadowVertex& each : {a, b, c, a, c, d}) shadows_.push_back(each);
}

}  // namespace render
