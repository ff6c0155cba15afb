#pragma once

#include <vector>

#include "sim/fields/test_flows.h"
#include "sim/front/tracker.h"

namespace sim::fields {

// How near a tracker's points come to a front that is known. Lengths in cells of `cell` metres.
struct FrontScore {
    double rms = 0, p95 = 0;            // distance of the points from the front, on edges that it crosses
    double missed = 0, false_cuts = 0;  // share of the edges that the front crosses, of the cut ones
    double jumps =
        0;  // per second: points that move, come or go farther than the front can have carried them
    double true_jumps = 0;  // the same of points that lie exactly on the front
    double points = 0;      // in a step, on average
};

struct Trial {
    double seconds = 16, unscored = 1;  // how long, and how much of its beginning does not count
    double steps_per_second = 60;
    double cell = 1;  // of the mesh, m; also the unit of lengths in the score
    // Where the flow's coordinates lie on the mesh: flow = turn · mesh + shift.
    double turn = 0;  // radians, about the middle of the unit square
    glm::dvec2 shift{0, 0};
    double noise = 0;   // of each component of each velocity at each step, as a standard deviation, m/s
    double salt = 0;    // share of the vertices whose velocity is turned round for a step, others in each
    bool hold = false;  // of Section 3.3
};

// Runs a source through a flow.
FrontScore score(const front::Mesh& mesh, const front::Rule& rule, front::PointSource source,
                 const TestFlow& flow, const Trial& trial);

}  // namespace sim::fields
