#include "sim/carried/trunk.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "sim/carried/ground_at.h"
#include "sim/core/chance.h"
#include "sim/core/ramp.h"

namespace sim::carried {
namespace {

constexpr float kTrunkTakesOn = 0.5f;  // s, in which a trunk takes on the speed of a flow
constexpr float kTrunkFaster = 1.05f;  // its speed, of the mean of the flow
constexpr float kFriction = 5;         // m/s², of a trunk on the ground
constexpr float kTrunkStill = 0.15f;   // m/s; a slower trunk stops
constexpr float kTilts = 1.5f;         // 1/s, rate at which it follows the surface
constexpr float kRaised = 0.35f;       // greatest sine by which one end looks out

glm::vec2 across(glm::vec2 v) {
    return {-v.y, v.x};
}

// How the ground takes hold of one half of a trunk.
struct Hold {
    GroundAt ground;
    float strength;  // 0 to 1
};
std::array<Hold, 2> holds_of(const View& world, std::span<const float> first_depth, const Body& trunk) {
    std::array<Hold, 2> holds;
    for (std::size_t i = 0; i < holds.size(); ++i) {
        const glm::vec2 half = (i == 0 ? -0.35f : 0.35f) * trunk.size * glm::vec2(trunk.turn);
        holds[i].ground = ground_at(world, first_depth, glm::vec2(trunk.at) + half);
        holds[i].strength = ramp(0.05f, 0.35f, holds[i].ground.flow);
    }
    return holds;
}

// Height and tilt: between the surface under its halves, sunk, with one end higher.
void rest_on(const std::array<Hold, 2>& holds, float dt_s, Body& trunk) {
    const float rise = (holds[1].ground.surface - holds[0].ground.surface) / (0.7f * trunk.size);
    const float raised = kRaised * (own(trunk, 7) - 0.35f) * (0.4f + 0.6f * trunk.sunk);
    const glm::vec3 wanted = glm::normalize(glm::vec3(glm::normalize(glm::vec2(trunk.turn)), rise + raised));
    const float share = std::min(kTilts * dt_s, 1.f);
    const glm::vec3 axis(trunk.turn);
    const bool lies = trunk.velocity == glm::vec3(0) && glm::distance(axis, wanted) < 2e-3f;
    if (!lies) trunk.turn = glm::vec4(glm::normalize(axis + share * (wanted - axis)), 0);
    const float soft = std::max(holds[0].ground.flow + std::max(holds[0].ground.loose, 0.f),
                                holds[1].ground.flow + std::max(holds[1].ground.loose, 0.f));
    const float thick = thickness_of(trunk), deep = (0.15f + 0.65f * own(trunk, 8)) * ramp(0, 0.5f, soft);
    const float sinks = deep - trunk.sunk;
    if (std::abs(sinks) > 1e-3f) trunk.sunk += share * sinks;
    trunk.at.z = 0.5f * (holds[0].ground.surface + holds[1].ground.surface) + (0.5f - trunk.sunk) * thick +
                 0.3f * raised * trunk.size;
}

}  // namespace

float thickness_of(const Body& trunk) {
    return trunk.size * (0.034f + 0.014f * own(trunk, 6));
}

void move_trunk(const View& world, std::span<const float> first_depth, float dt_s, Body& trunk) {
    const std::array<Hold, 2> before = holds_of(world, first_depth, trunk);
    if (before[0].ground.outside || before[1].ground.outside) return;
    const float firm = 0.5f * (before[0].strength + before[1].strength);
    const glm::vec2 drawn_0 = kTrunkFaster * before[0].strength * before[0].ground.velocity,
                    drawn_1 = kTrunkFaster * before[1].strength * before[1].ground.velocity;
    glm::vec2 v(trunk.velocity);
    v += std::min(dt_s / kTrunkTakesOn, 1.f) * firm * (0.5f * (drawn_0 + drawn_1) - v);
    const float speed = glm::length(v);
    if (speed > 0) v *= std::max(1 - dt_s * (1 - firm) * kFriction / speed, 0.f);
    const glm::vec2 apart = (drawn_1 - drawn_0) / (0.7f * trunk.size);
    const bool rests = speed < kTrunkStill && glm::length(drawn_0 + drawn_1) < 2 * kTrunkStill;
    if (rests) v = {0, 0};
    trunk.velocity = glm::vec3(v, 0);
    trunk.at += dt_s * trunk.velocity;
    if (!rests && firm > 0) {
        const glm::vec2 axis(trunk.turn), way = across(axis) / std::max(glm::length(axis), 0.1f);
        const float turn = glm::clamp(dt_s * firm * glm::dot(way, apart), -0.05f, 0.05f);
        trunk.turn = glm::vec4(glm::normalize(glm::vec3(axis + turn * across(axis), trunk.turn.z)), 0);
    }
    rest_on(holds_of(world, first_depth, trunk), dt_s, trunk);
}

}  // namespace sim::carried
