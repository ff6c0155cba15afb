#pragma once

#include <limits>
#include <memory>
#include <span>

#include "sim/front/tracker.h"

// The interface of a source of point positions. Needed only to add one; all others include tracker.h.

namespace sim::front {

inline constexpr double kNever = -std::numeric_limits<double>::infinity();  // a time, s

struct TrackedMoment {
    const Detector& detector;
    const Flow& flow;
    double time, dt;                  // now, and since the previous moment, s
    std::span<const Point> previous;  // points of the previous moment
    const PointHold* hold;            // null: a vertex is passed when the front passes it
    Workers& workers;
};

class PointEstimator {
  public:
    virtual ~PointEstimator() = default;
    // `points`: one for each cut edge. Existing points come with their previous values and their new age; new
    // ones have f = ½, speed 0 and age 0.
    virtual void locate(const TrackedMoment& now, std::span<Point> points) = 0;
};

std::unique_ptr<PointEstimator> paper_estimator(const Mesh& mesh);
std::unique_ptr<PointEstimator> fit_estimator(const Mesh& mesh);
std::unique_ptr<PointEstimator> level_estimator(const Mesh& mesh, float level);

}  // namespace sim::front
