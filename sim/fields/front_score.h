#pragma once

#include <vector>

#include "sim/fields/test_flows.h"
#include "sim/front/tracker.h"

namespace sim::fields {

// How near a tracker's points are to a known front. Lengths are in cells of `cell` metres.
struct FrontScore {
    double rms = 0, p95 = 0;            // distance of the points from the front, on edges that it crosses
    double missed = 0, false_cuts = 0;  // shares of the edges that the front crosses, and of the cut edges
    double jumps = 0;  // per second: points that move, appear or vanish farther than the front can have moved
    double true_jumps = 0;  // the same for points exactly on the front
    double points = 0;      // per step, on average
};

struct Trial {
    double seconds = 16, unscored = 1;  // duration, and how much of its beginning is not scored
    double steps_per_second = 60;
    double cell = 1;  // of the mesh, m; the unit of length in the score
    // Transforms mesh coordinates to flow coordinates: flow = turn · mesh + shift.
    double turn = 0;  // radians, about the middle of the unit square
    glm::dvec2 shift{0, 0};
    double noise = 0;   // standard deviation of noise on each velocity component in each step, m/s
    double salt = 0;    // share of vertices with reversed velocity; others in each step
    bool hold = false;  // hold late points (section 3.3)
};

// Runs a point source through a flow and scores it.
FrontScore score(const front::Mesh& mesh, const front::Rule& rule, front::PointSource source,
                 const TestFlow& flow, const Trial& trial);

}  // namespace sim::fields
