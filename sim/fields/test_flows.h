#pragma once

#include <string>
#include <vector>

#include <glm/vec2.hpp>

namespace sim::fields {

// Flows on the unit square whose fronts are known exactly: the paper's four scenes, whose speeds it does not
// give, two drops, a crowd and a rift. For who looks on, never for a step: they call libm.
struct TestFlow {
    enum class Kind {
        kOpposed,   // two ways on either side of a line at rest; (i)
        kSwinging,  // the same, and the line swings along its normal; (ii)
        kPinwheel,  // four ways between two lines that turn; (iii)
        kDisc,      // a disc that goes round in a flow straight down; (iv)
        kDrops,     // two discs that meet, are one, and part again
        kCrowd,     // lanes of a crowd in both directions, as wide as they please
        kRift       // kSwinging, but the ways on either side fade along the line until nothing moves
    };
    Kind kind = Kind::kOpposed;
    double flow_speed = 0.2;       // m/s, ≥ 0
    double front_speed = 1;        // how fast time goes for the front, times its usual; may be below 0
    double angle = 0;              // kOpposed, kSwinging, kRift: of the line, radians
    double smooth = 0;             // m/s; adds a steady field without jumps, (sin 2πy, sin 2πx) times this
    glm::dvec2 through{0.5, 0.5};  // the middle of all, m: a point of the line, where lines cross, …

    // `time` below is the front's, s: it goes by front_speed times as fast as everybody's, and may do so
    // while speeds change.

    // Parts of the plane that move alike, numbered from 0.
    int region(const glm::dvec2& x, double time) const;
    // Whether a front runs between two places near each other, across which velocities jump by so much, m/s.
    bool parts(const glm::dvec2& a, const glm::dvec2& b, double time, double jump) const;
    // m/s
    glm::vec2 velocity(const glm::dvec2& x, double time) const;
    // To the nearest point of a front, m.
    double distance(const glm::dvec2& x, double time) const;
    // The greatest normal speed of a front within the square, m/s.
    double greatest_front_speed() const;

    // Of a region, without what is smooth on top and before it fades, m/s.
    glm::vec2 of_region(int region, double time) const;
};

// With the numbers of the paper's figures as we read them; `cell`: of the grid, m.
TestFlow opposed(double cell, double share);  // (i), `share` of a cell above the row at 0.5 or just below it
TestFlow swinging(double degrees);            // (ii)
TestFlow pinwheel();                          // (iii)
TestFlow disc();                              // (iv)
TestFlow drops();
TestFlow crowd();
TestFlow rift(double degrees);

}  // namespace sim::fields
