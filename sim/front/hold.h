#pragma once

#include <span>
#include <vector>

#include "sim/front/detector.h"
#include "sim/front/tracker.h"

namespace sim::front {

// Section 3.3 of the paper: where a front leaves its edges through a vertex before the points on them have
// come there, they are kept, and go on to it faster; else they would vanish on their way. What is kept is the
// vertex itself, as it was before the front: so cuts stay those of one front, and textures their sides. For
// so long edges are cut that the front has left, and others are not that it has entered.
class PointHold {
  public:
    // The mesh must outlive it. No rule by level: a point that is where the level is does not come late.
    PointHold(const Mesh& mesh, const Rule& rule);

    // The flow of `time`, `dt` after the last, as it is to be looked at: all but what is held. Valid until
    // the next call. `seen` and `points` are what came of the last.
    Flow delay(const Flow& flow, double time, double dt, const Detector& seen, std::span<const Point> points);

    // When the front did pass a vertex that is seen to flip now, s.
    double passed(int vertex) const { return passed_[vertex]; }
    // Of a cut edge the end through which the front has left it, where that is held; else -1.
    int left_through(int edge) const;
    // For how many steps a vertex is held, this one among them, if none of its points comes before; 0: it is
    // not held.
    int steps_left(int vertex) const { return steps_left_[vertex]; }
    // How far a point that is late goes in a step, m.
    double hurried(const Point& point, double dt) const;

  private:
    struct Late {
        double way;  // that the farthest of those points has to go which the front left behind, m
        double age;  // for how long the front was on one of their edges at most, s
        bool any;    // does one not come in this step?
    };
    Late late_at(int vertex, double dt, const Detector& seen, std::span<const Point> points) const;

    const Mesh& mesh_;
    Detector actual_;
    std::vector<glm::vec2> velocity_, before_;  // as looked at, now and a step before, m/s
    std::vector<double> passed_;                // of each vertex, s
    std::vector<int> steps_left_;               // of each vertex
    std::vector<int> held_;                     // vertices
};

}  // namespace sim::front
