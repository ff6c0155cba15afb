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

// A discontinuity point: where a front crosses a cut edge.
struct Point {
    int edge;
    float f;      // 0 at the edge's vertex a … 1 at b
    float speed;  // along the edge, positive from a to b, m/s; 0 until known
    float age;    // since the edge was cut, s
};

// The source of a point's position on its edge.
enum class PointSource {
    kHalf,   // always in the middle
    kPaper,  // section 3 of Rodríguez-Cerro et al.: slowness from the edges that the front has left
    kFit,    // a piece of moving front, fitted to the flips of vertices around (tracker_fit.cpp)
    kLevel   // where a scalar known at the vertices, linear in between, reaches its level
};
std::string_view to_string(PointSource source);
std::optional<PointSource> source_named(std::string_view name);

class PointHold;
class PointEstimator;

// Tracks the discontinuity fronts of a flow, step after step. A view: it does not change the flow. Its cost
// grows with the length of the fronts, except for the detector's scan of every edge.
class Tracker {
  public:
    // The mesh must outlive the tracker. kLevel needs a scalar with every flow, and takes the level from the
    // rule, whatever the rule's kind. `hold` keeps late points (hold.h); it requires kPaper and a rule other
    // than kLevel.
    Tracker(const Mesh& mesh, const Rule& rule, PointSource source, bool hold = false);
    ~Tracker();
    Tracker(const Tracker&) = delete;
    Tracker& operator=(const Tracker&) = delete;

    // Advances to the flow `dt` seconds later, > 0; the first call sets the initial flow. Results are
    // bit-identical for any number of workers.
    void advance(const Flow& flow, double dt, Workers& workers);

    const Mesh& mesh() const { return detector_.mesh(); }
    const Detector& detector() const { return detector_; }
    PointSource source() const { return source_; }
    // The points, one for each edge of detector().cut(), in that order.
    std::span<const Point> points() const { return points_; }
    glm::vec2 position(const Point& point) const;  // m
    // Number of vertices that a front passed in this step faster than about half a cell per step: none of the
    // edges that it left there had been cut for longer than a step. Points there are little more than
    // guesses.
    int outrun() const { return outrun_; }

  private:
    int count_outrun(double dt) const;

    Detector detector_;
    std::unique_ptr<PointHold> hold_;  // null unless requested
    PointSource source_;
    std::vector<Point> points_, previous_;
    std::unique_ptr<PointEstimator> estimator_;  // null for kHalf
    double time_ = 0;                            // s
    int outrun_ = 0;
};

}  // namespace sim::front
