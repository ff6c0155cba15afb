#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "sim/front/detector.h"

namespace sim {
class Workers;
}

namespace sim::front {

// Where a front crosses a cut edge.
struct Point {
    int edge;
    float f;      // 0 at the edge's vertex a … 1 at b
    float speed;  // along the edge, positive from a to b, m/s; 0 until it is known
    float age;    // since the edge was cut, s
};

// Where on its edge a point lies is told by one of four sources.
enum class PointSource {
    kHalf,   // always in the middle
    kPaper,  // Rodríguez-Cerro et al., section 3: speed from the edges that the front left before
    kFit,    // a piece of moving front fitted to the flips of the vertices around (tracker_fit.cpp)
    kLevel   // where a scalar that is known at the vertices, linear between them, has its level
};
std::string_view to_string(PointSource source);
std::optional<PointSource> source_named(std::string_view name);

class PointHold;
class PointEstimator;

// Follows fronts through a flow, step after step: a view, which changes nothing of the flow. Its cost grows
// with the length of the fronts, but for the detector's look at every edge.
class Tracker {
  public:
    // The mesh must outlive it. kLevel wants a scalar with every flow, and takes its level from the rule
    // whatever kind that is. Of kPaper alone, and with no rule by level, `hold` keeps points that are late
    // (hold.h).
    Tracker(const Mesh& mesh, const Rule& rule, PointSource source, bool hold = false);
    ~Tracker();
    Tracker(const Tracker&) = delete;
    Tracker& operator=(const Tracker&) = delete;

    // To the flow as it is `dt` seconds later, > 0; the first call tells how it begins. However many workers:
    // the same bits.
    void advance(const Flow& flow, double dt, Workers& workers);

    const Mesh& mesh() const { return detector_.mesh(); }
    const Detector& detector() const { return detector_; }
    PointSource source() const { return source_; }
    // One for each edge of detector().cut(), in that order.
    std::span<const Point> points() const { return points_; }
    glm::vec2 position(const Point& point) const;  // m
    // Vertices that a front passed in this step on its way at more than about half a cell per step: none of
    // the edges that it left there had been cut for longer than a step. Its points are hardly more than
    // guesses there.
    int outrun() const { return outrun_; }

  private:
    int count_outrun(double dt) const;

    Detector detector_;
    std::unique_ptr<PointHold> hold_;  // none unless it was asked for
    PointSource source_;
    std::vector<Point> points_, previous_;
    std::unique_ptr<PointEstimator> estimator_;  // none for kHalf
    double time_ = 0;                            // s
    int outrun_ = 0;
};

}  // namespace sim::front
