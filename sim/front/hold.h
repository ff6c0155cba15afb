#pragma once

#include <span>
#include <vector>

#include "sim/front/detector.h"
#include "sim/front/tracker.h"

namespace sim::front {

// Holds late discontinuity points (section 3.3 of the paper): if a front leaves its edges through a vertex
// before the points on them arrive there, the points are kept and hurried to the vertex. Otherwise they would
// vanish on the way. The vertex itself is held as it was before the front, so that the cut edges remain those
// of one front and textures keep their sides. Meanwhile edges that the front has left are cut, and edges that
// it has entered are not.
class PointHold {
  public:
    // The mesh must outlive this object. The rule must not be kLevel, whose points are never late.
    PointHold(const Mesh& mesh, const Rule& rule);

    // Returns the flow at `time`, `dt` after the previous one, with held vertices as they were. The result is
    // valid until the next call. `seen` and `points` are the results of the previous step.
    Flow delay(const Flow& flow, double time, double dt, const Detector& seen, std::span<const Point> points);

    // When the front really passed a vertex that flips now, s.
    double passed(int vertex) const { return passed_[vertex]; }
    // The held end of a cut edge through which the front has left it; -1: none.
    int left_through(int edge) const;
    // Steps for which a vertex is still held, this one included, unless its points arrive earlier; 0: not
    // held.
    int steps_left(int vertex) const { return steps_left_[vertex]; }
    // Step of a late point, m.
    double hurried(const Point& point, double dt) const;

  private:
    struct Late {
        double way;  // farthest distance that one of its points has left to the vertex, m
        double age;  // longest time that the front was on one of their edges, s
        bool any;    // at least one does not arrive in this step
    };
    Late late_at(int vertex, double dt, const Detector& seen, std::span<const Point> points) const;

    const Mesh& mesh_;
    Detector actual_;
    std::vector<glm::vec2> velocity_, before_;  // as seen, now and a step before, m/s
    std::vector<double> passed_;                // of each vertex, s
    std::vector<int> steps_left_;               // of each vertex
    std::vector<int> held_;                     // vertices
};

}  // namespace sim::front
