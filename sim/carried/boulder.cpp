#include "sim/carried/boulder.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "sim/carried/ground_at.h"
#include "sim/core/chance.h"
#include "sim/core/ramp.h"

namespace sim::carried {
namespace {

constexpr float kGravity = 9.81f;  // m/s²
constexpr float kTakesOn = 0.35f;  // s, in which a boulder takes on the speed of a flow that is deep for it
constexpr float kFaster = 0.95f,
                kFastest = 1.35f;  // speed of a boulder in a flow, of its mean: by how high it rides
constexpr float kAside = 0.3f;     // of that, to either side, as it is jostled
constexpr float kAtFront = 0.25f;  // more of that, where nothing flows ahead
constexpr float kStill = 0.25f;    // m/s; a slower boulder stops on ground that is not too steep for it
constexpr float kSteepest = 1.1f;  // tangent of a slope on which a boulder can rest
constexpr float kBounces = 2.2f;   // per second, of a boulder that rolls
constexpr float kKept = 0.25f;     // share of its fall that a boulder bounces by
constexpr float kSinks = 0.7f, kRises = 1.6f;  // 1/s, rates at which it sinks and comes up
constexpr float kWall = 1.3f;                  // slope of a step that no boulder climbs

// Turns an orientation by an angular velocity, rad/s.
glm::vec4 turned(const glm::vec4& q, const glm::vec3& spin, float dt_s) {
    const glm::vec3 v(q), half = 0.5f * dt_s * spin;
    return glm::normalize(glm::vec4(v + q.w * half + glm::cross(half, v), q.w - glm::dot(half, v)));
}

// Friction of a boulder that rolls: most are blocky and stay where they are left, few are round and run out.
float rolling_friction(const Body& body) {
    const float round = own(body, 1);
    return round < 0.65f ? 0.55f + 0.4f * own(body, 2) : 0.14f + 0.3f * own(body, 2);
}

// How far a boulder sinks into what is soft under it, as a share of its size.
float rest_of(const Body& body, float soft) {
    const float wanted = 0.22f + 0.45f * own(body, 3);
    return std::max(std::min(wanted, 0.8f * soft / body.size), 0.06f);
}

// How a flow carries a body: at which velocity in plan, and how firmly.
struct Drive {
    glm::vec2 velocity;
    float strength;  // 0 to 1
};
Drive drive_of(const View& world, const Body& body, const GroundAt& here) {
    const float strength = ramp(0.08f * body.size, 0.5f * body.size, here.flow);
    if (strength <= 0) return {{0, 0}, 0};
    const float speed = glm::length(here.velocity);
    if (speed < 0.05f) return {{0, 0}, strength};
    const glm::vec2 ahead = here.velocity / speed * std::max(1.5f * world.grid.dx, speed);
    const float front = 1 - ramp(0.02f, 0.25f, ground_at(world, {}, glm::vec2(body.at) + ahead).flow);
    const float along = std::lerp(kFaster, kFastest, own(body, 4)) + kAtFront * front * own(body, 7),
                aside = kAside * (own(body, 8) - 0.5f);
    const glm::vec2 across(-here.velocity.y, here.velocity.x);
    return {along * here.velocity + aside * across, strength};
}

// Velocity in plan after dt: carried by the flow, else rolling on the ground.
glm::vec2 driven(const View& world, const Body& body, const GroundAt& here, float dt_s) {
    glm::vec2 v(body.velocity);
    const Drive drive = drive_of(world, body, here);
    v += std::min(dt_s / kTakesOn, 1.f) * drive.strength * (drive.velocity - v);
    const float steep = std::sqrt(glm::dot(here.slope, here.slope)), flat = 1 / std::sqrt(1 + steep * steep);
    const float speed = glm::length(v), loose = 1 - drive.strength;
    if (speed < kStill && steep < kSteepest && glm::length(drive.velocity) < 2 * kStill) return {0, 0};
    v -= dt_s * loose * kGravity * flat * flat * here.slope;
    if (speed > 0) v *= std::max(1 - dt_s * loose * kGravity * flat * rolling_friction(body) / speed, 0.f);
    return v;
}

// Spin of a body that rolls over the ground without sliding; what rides in a flow turns less.
glm::vec3 spin_of(const Body& body, const GroundAt& here) {
    const float rolls = 1 - 0.7f * ramp(0.1f * body.size, 0.6f * body.size, here.flow);
    return 2 * rolls / body.size * glm::vec3(-body.velocity.y, body.velocity.x, 0);
}

// Height: it follows the ground, or flies until it meets it again.
void follow_ground(Body& body, const GroundAt& before, const GroundAt& now, std::int64_t tick, float dt_s) {
    const float along = (now.surface - before.surface) / dt_s;
    const float sinks = rest_of(body, now.flow + std::max(now.loose, 0.f)) - body.sunk;
    body.sunk +=
        std::abs(sinks) < 1e-3f ? sinks : std::min((sinks < 0 ? kRises : kSinks) * dt_s, 1.f) * sinks;
    const float lowest = now.surface + (0.5f - body.sunk) * body.size;
    const float speed = glm::length(glm::vec2(body.velocity));
    body.velocity.z -= kGravity * dt_s;
    body.at.z += dt_s * body.velocity.z;
    if (body.at.z > lowest) return;
    const float impact = along - body.velocity.z;
    body.at.z = lowest;
    body.velocity.z = along + (impact > 1.2f ? kKept * impact : 0);
    if (speed < 2) return;
    const std::uint32_t bits = mixed(static_cast<std::uint64_t>(tick) * 0x51ED270B153A4D2Full ^ body.seed);
    if (share_of(bits) < kBounces * dt_s)
        body.velocity.z +=
            speed * (0.08f + 0.22f * share_of(mixed(bits))) * (1 - 0.6f * ramp(0, body.size, now.flow));
}

bool is_built_on(const View& world, const Body& body) {
    if (!world.things) return false;
    const glm::dvec2 at(body.at);
    return std::ranges::any_of(world.things->list, [&](const Thing& thing) {
        if (thing.is_line() || thing.destroyed()) return false;
        const glm::dvec2 from = at - glm::dvec2(thing.x, thing.y), along(thing.front_x, thing.front_y);
        const double reach = 0.45 * static_cast<double>(body.size);
        return std::abs(glm::dot(from, along)) < thing.length / 2 + reach &&
               std::abs(along.x * from.y - along.y * from.x) < thing.width / 2 + reach;
    });
}

}  // namespace

void move_boulder(const View& world, std::span<const float> first_depth, float dt_s, Body& body) {
    const glm::vec3 was = body.at;
    const GroundAt before = ground_at(world, first_depth, glm::vec2(body.at));
    if (before.outside) return;
    const glm::vec2 v = driven(world, body, before, dt_s);
    body.velocity.x = v.x, body.velocity.y = v.y;
    body.at.x += dt_s * v.x, body.at.y += dt_s * v.y;
    GroundAt now = ground_at(world, first_depth, glm::vec2(body.at));
    const float step = dt_s * glm::length(v);
    if (step > 0 && (now.surface - before.surface > kWall * step + 0.05f || is_built_on(world, body))) {
        body.at = was;  // it meets a wall
        body.velocity.x *= -0.2f, body.velocity.y *= -0.2f;
        now = before;
    }
    if (body.velocity.x != 0 || body.velocity.y != 0)
        body.turn = turned(body.turn, spin_of(body, before), dt_s);
    follow_ground(body, before, now, world.tick, dt_s);
}

}  // namespace sim::carried
