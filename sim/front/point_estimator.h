#pragma once

#include <limits>
#include <memory>
#include <span>

#include "sim/front/tracker.h"

// How a source of position is asked. For who adds one; everybody else wants tracker.h.

namespace sim::front {

inline constexpr double kNever = -std::numeric_limits<double>::infinity();  // a time, s

struct TrackedMoment {
    const Detector& detector;
    const Flow& flow;
    double time, dt;                  // now, and since the moment before, s
    std::span<const Point> previous;  // the points of the moment before, as they lay then
    const PointHold* hold;            // none: a vertex is passed when the front passes it
    Workers& workers;
};

class PointEstimator {
  public:
    virtual ~PointEstimator() = default;
    // `points`: one for each cut edge. Those that stay are as they were, but for their age; those born now
    // have f = ½, speed 0 and age 0.
    virtual void locate(const TrackedMoment& now, std::span<Point> points) = 0;
};

std::unique_ptr<PointEstimator> paper_estimator(const Mesh& mesh);
std::unique_ptr<PointEstimator> fit_estimator(const Mesh& mesh);
std::unique_ptr<PointEstimator> level_estimator(const Mesh& mesh, float level);

}  // namespace sim::front
