#include "sim/fields/test_flows.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>

namespace sim::fields {
namespace {

constexpr double kTurn = 2 * std::numbers::pi;

constexpr double kSwing = 0.2, kSwingPeriod = 8;                         // m, s
constexpr double kPinwheelPeriod = 20, kPinwheelAngle = 0.1;             // s, radians
constexpr double kDiscRadius = 0.15, kDiscOrbit = 0.2, kDiscPeriod = 8;  // m, m, s
constexpr double kDiscFall = 1.5;                                        // as a multiple of the flow's speed
// m; greatest distance from the centre, m; s
constexpr double kDropRadius = 0.12, kApart = 0.25, kDropPeriod = 10;
constexpr double kLane = 0.16, kLaneSwing = 0.05, kLanePeriod = 10;  // m, m, s
constexpr double kFadeFrom = -0.3, kFadeTo = 0.3;                    // m along the rift

glm::dvec2 direction_of(double angle) {
    return {std::cos(angle), std::sin(angle)};
}

glm::dvec2 left_of(const glm::dvec2& direction) {
    return {-direction.y, direction.x};
}

// Signed distances to the fronts.
double from_line(const TestFlow& flow, const glm::dvec2& x, double time) {
    const double swing =
        flow.kind == TestFlow::Kind::kOpposed ? 0 : kSwing * std::sin(kTurn * time / kSwingPeriod);
    return glm::dot(x - flow.through, left_of(direction_of(flow.angle))) - swing;
}

// Share of the flow's speed that remains at a place: 1 … 0, smoothly along the rift.
double fade(const TestFlow& flow, const glm::dvec2& x) {
    const double along = glm::dot(x - flow.through, direction_of(flow.angle));
    const double t = std::clamp((along - kFadeFrom) / (kFadeTo - kFadeFrom), 0.0, 1.0);
    return 1 - t * t * (3 - 2 * t);
}

// Coordinates in the frame that rotates with the pinwheel.
glm::dvec2 turned(const TestFlow& flow, const glm::dvec2& x, double time) {
    const glm::dvec2 u = direction_of(kTurn * time / kPinwheelPeriod + kPinwheelAngle);
    const glm::dvec2 from = x - flow.through;
    return {glm::dot(from, u), glm::dot(from, left_of(u))};
}

double disc_angle(double time) {
    return kTurn * time / kDiscPeriod;
}

double from_disc(const TestFlow& flow, const glm::dvec2& x, double time) {
    const glm::dvec2 centre = flow.through + kDiscOrbit * direction_of(disc_angle(time));
    return glm::length(x - centre) - kDiscRadius;
}

// Negative inside either drop. Near the front it approximates the distance.
double from_drops(const TestFlow& flow, const glm::dvec2& x, double time) {
    const glm::dvec2 way(kApart * std::cos(kTurn * time / kDropPeriod), 0);
    const glm::dvec2 from = x - flow.through;
    return std::min(glm::length(from - way), glm::length(from + way)) - kDropRadius;
}

// Position across lanes that are stacked along y and sway together, in lanes.
double lane_at(const TestFlow& flow, const glm::dvec2& x, double time) {
    const double sway = kLaneSwing * std::sin(kTurn * (x.x + time / kLanePeriod));
    return (x.y - flow.through.y - sway) / kLane;
}

}  // namespace

int TestFlow::region(const glm::dvec2& x, double time) const {
    switch (kind) {
        case Kind::kOpposed:
        case Kind::kSwinging:
        case Kind::kRift:
            return from_line(*this, x, time) > 0;
        case Kind::kPinwheel: {
            const glm::dvec2 p = turned(*this, x, time);
            return (p.x > 0) + 2 * (p.y > 0);
        }
        case Kind::kDisc:
            return from_disc(*this, x, time) > 0;
        case Kind::kDrops:
            return from_drops(*this, x, time) > 0;
        case Kind::kCrowd:
            return static_cast<int>(std::floor(lane_at(*this, x, time))) & 1;
    }
    return 0;
}

bool TestFlow::parts(const glm::dvec2& a, const glm::dvec2& b, double time, double jump) const {
    if (region(a, time) == region(b, time)) return false;
    return kind != Kind::kRift || 2 * flow_speed * fade(*this, (a + b) / 2.0) >= jump;
}

glm::vec2 TestFlow::velocity(const glm::dvec2& x, double time) const {
    const glm::dvec2 on_top = smooth * glm::dvec2(std::sin(kTurn * x.y), std::sin(kTurn * x.x));
    const double left = kind == Kind::kRift ? fade(*this, x) : 1;
    return static_cast<float>(left) * of_region(region(x, time), time) + glm::vec2(on_top);
}

glm::vec2 TestFlow::of_region(int where, double time) const {
    switch (kind) {
        case Kind::kOpposed:
        case Kind::kSwinging:
        case Kind::kRift:
            return glm::vec2((where ? flow_speed : -flow_speed) * direction_of(angle));
        case Kind::kPinwheel: {
            const glm::dvec2 ways[] = {{0, 1}, {1, 0}, {-1, 0}, {0, -1}};
            return glm::vec2(flow_speed * ways[where]);
        }
        case Kind::kDisc: {
            const double speed = kTurn * front_speed / kDiscPeriod * kDiscOrbit;
            return where ? glm::vec2(0, -kDiscFall * flow_speed)
                         : glm::vec2(speed * left_of(direction_of(disc_angle(time))));
        }
        case Kind::kDrops:
            return glm::vec2(0, where ? flow_speed : -flow_speed);
        case Kind::kCrowd:
            return {where ? flow_speed : -flow_speed, 0};
    }
    return {0, 0};
}

double TestFlow::distance(const glm::dvec2& x, double time) const {
    switch (kind) {
        case Kind::kOpposed:
        case Kind::kSwinging:
        case Kind::kRift:
            return std::abs(from_line(*this, x, time));
        case Kind::kPinwheel: {
            const glm::dvec2 p = turned(*this, x, time);
            return std::min(std::abs(p.x), std::abs(p.y));
        }
        case Kind::kDisc:
            return std::abs(from_disc(*this, x, time));
        case Kind::kDrops:
            return std::abs(from_drops(*this, x, time));
        case Kind::kCrowd: {
            // Distance to the tangent of the sine above or below: near a front it approximates the true
            // distance.
            const double lane = lane_at(*this, x, time);
            const double slope = kLaneSwing * kTurn * std::cos(kTurn * (x.x + time / kLanePeriod));
            return std::abs(lane - std::round(lane)) * kLane / std::sqrt(1 + slope * slope);
        }
    }
    return 0;
}

double TestFlow::greatest_front_speed() const {
    const double times = std::abs(front_speed);
    switch (kind) {
        case Kind::kOpposed:
            return 0;
        case Kind::kSwinging:
        case Kind::kRift:
            return times * kTurn / kSwingPeriod * kSwing;
        case Kind::kPinwheel:
            return times * kTurn / kPinwheelPeriod * std::numbers::sqrt2 / 2;
        case Kind::kDisc:
            return times * kTurn / kDiscPeriod * kDiscOrbit;
        case Kind::kDrops:
            return times * kTurn / kDropPeriod * kApart;
        case Kind::kCrowd:
            return times * kTurn / kLanePeriod * kLaneSwing;
    }
    return 0;
}

TestFlow opposed(double cell, double share) {
    const double row = std::floor(0.5 / cell + 1e-9) * cell;
    return {.kind = TestFlow::Kind::kOpposed, .through = {0.5, row + share * cell}};
}

TestFlow swinging(double degrees) {
    return {.kind = TestFlow::Kind::kSwinging, .angle = degrees * kTurn / 360, .through = {0.503, 0.497}};
}

TestFlow pinwheel() {
    return {.kind = TestFlow::Kind::kPinwheel, .through = {0.503, 0.497}};
}

TestFlow disc() {
    return {.kind = TestFlow::Kind::kDisc};
}

TestFlow drops() {
    return {.kind = TestFlow::Kind::kDrops};
}

TestFlow crowd() {
    return {.kind = TestFlow::Kind::kCrowd};
}

TestFlow rift(double degrees) {
    TestFlow flow = swinging(degrees);
    flow.kind = TestFlow::Kind::kRift;
    return flow;
}

}  // namespace sim::fields
