#include "sim/front/hold.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "sim/core/check.h"

namespace sim::front {
namespace {

// Limits on holding a vertex: a time, and a share of the time that the front took for an edge. Beyond them
// the view would lag more than it would jump.
constexpr double kLongest = 1 / 15.0;  // s
constexpr double kMostOfCrossing = 0.3;

// A late point moves at this multiple of its speed, up to this speed and step; a longer step would itself be
// a jump. At 60 steps/s or more it covers a little more than a cell in kLongest. A vertex is not held if one
// of its points cannot arrive in time.
constexpr double kHaste = 2;
constexpr double kFastest = 16;     // cells/s
constexpr double kFarthest = 0.27;  // cells

// m
double farthest_step(double cell, double dt) {
    return std::min(kFastest * dt, kFarthest) * cell;
}

}  // namespace

PointHold::PointHold(const Mesh& mesh, const Rule& rule)
    : mesh_(mesh),
      actual_(mesh, rule),
      velocity_(mesh.position.size()),
      passed_(mesh.position.size(), 0),
      steps_left_(mesh.position.size(), 0) {
    CHECK(rule.kind != Rule::Kind::kLevel);
}

Flow PointHold::delay(const Flow& flow, double time, double dt, const Detector& seen,
                      std::span<const Point> points) {
    actual_.update(flow);
    for (const int v : held_) steps_left_[v] = late_at(v, dt, seen, points).any ? steps_left_[v] - 1 : 0;
    for (const int v : actual_.flipped()) {
        passed_[v] = time - dt / 2;
        const bool came_back = std::exchange(steps_left_[v], 0) > 0;  // nobody saw it leave
        const Late late = late_at(v, dt, seen, points);
        if (came_back || !late.any) continue;
        const double longest = std::min(kLongest, kMostOfCrossing * late.age);
        const int steps = static_cast<int>(longest / dt + 1e-6);
        if (late.way > steps * farthest_step(mesh_.cell[v], dt)) continue;
        steps_left_[v] = steps;
        held_.push_back(v);
    }
    std::erase_if(held_, [&](int v) { return steps_left_[v] == 0; });
    before_.swap(velocity_);
    velocity_.assign(flow.velocity.begin(), flow.velocity.end());
    for (const int v : held_) velocity_[v] = before_[v];
    return {velocity_, flow.scalar};
}

int PointHold::left_through(int edge) const {
    if (actual_.is_cut(edge)) return -1;
    const auto [a, b] = mesh_.edge[edge];
    return steps_left_[a] > 0 ? a : steps_left_[b] > 0 ? b : -1;
}

double PointHold::hurried(const Point& point, double dt) const {
    const auto [a, b] = mesh_.edge[point.edge];
    const double run = std::abs(point.speed) * dt;
    return std::max(run, std::min(kHaste * run, farthest_step(std::min(mesh_.cell[a], mesh_.cell[b]), dt)));
}

PointHold::Late PointHold::late_at(int vertex, double dt, const Detector& seen,
                                   std::span<const Point> points) const {
    Late late{0, 0, false};
    for (const auto& spoke : mesh_.around(vertex)) {
        if (!seen.is_cut(spoke.edge) || actual_.is_cut(spoke.edge)) continue;
        const Point& point = points[seen.slot(spoke.edge)];
        const double share = mesh_.edge[spoke.edge].a == vertex ? point.f : 1 - point.f;
        const double way = share * mesh_.length[spoke.edge];
        late.way = std::max(late.way, way);
        late.age = std::max(late.age, point.age + dt);
        late.any = late.any || way > hurried(point, dt);
    }
    return late;
}

}  // namespace sim::front
