#pragma once

#include <string>
#include <vector>

#include <glm/vec2.hpp>

namespace sim::fields {

// Flows on the unit square whose fronts are known exactly: the paper's four scenes (it does not give their
// speeds), two drops, a crowd and a rift. For views only, never for a simulation step, because they call
// libm.
struct TestFlow {
    enum class Kind {
        kOpposed,   // opposed flow on either side of a line at rest; (i)
        kSwinging,  // the same, with a line that swings along its normal; (ii)
        kPinwheel,  // four flow directions between two rotating lines; (iii)
        kDisc,      // a disc that circles in a downward flow; (iv)
        kDrops,     // two discs that meet, merge and part again
        kCrowd,     // lanes of a crowd in both directions, of any width
        kRift       // kSwinging, but the flow on either side fades to nothing along the line
    };
    Kind kind = Kind::kOpposed;
    double flow_speed = 0.2;       // m/s, ≥ 0
    double front_speed = 1;        // speed of the front's clock, as a multiple of its usual; may be negative
    double angle = 0;              // kOpposed, kSwinging, kRift: angle of the line, radians
    double smooth = 0;             // m/s; adds a steady smooth field, (sin 2πy, sin 2πx) times this
    glm::dvec2 through{0.5, 0.5};  // centre, m: a point of the line, where lines cross, …

    // `time` below is the front's clock, s. It runs front_speed times as fast as the flow's, also while
    // speeds change.

    // Number of the region at a place, from 0. All of a region moves alike.
    int region(const glm::dvec2& x, double time) const;
    // True if a front with a velocity jump of at least `jump`, m/s, runs between two nearby places.
    bool parts(const glm::dvec2& a, const glm::dvec2& b, double time, double jump) const;
    // Velocity, m/s.
    glm::vec2 velocity(const glm::dvec2& x, double time) const;
    // Distance to the nearest point of a front, m.
    double distance(const glm::dvec2& x, double time) const;
    // Greatest normal speed of a front within the square, m/s.
    double greatest_front_speed() const;

    // Velocity of a region, without the smooth field and before fading, m/s.
    glm::vec2 of_region(int region, double time) const;
};

// Flows with the parameters that we read from the paper's figures. `cell`: of the grid, m.
TestFlow opposed(double cell, double share);  // (i), `share` of a cell above the row at 0.5 or just below it
TestFlow swinging(double degrees);            // (ii)
TestFlow pinwheel();                          // (iii)
TestFlow disc();                              // (iv)
TestFlow drops();
TestFlow crowd();
TestFlow rift(double degrees);

}  // namespace sim::fields
