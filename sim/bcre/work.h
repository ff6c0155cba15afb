#pragma once

#include <array>

#include "sim/bcre/constants.h"
#include "sim/simd/rows.h"
#include "sim/world/params.h"

// What the stages of a sub-step of `bcre` work on, as rows (rows.h).

namespace sim::bcre {

// A state of the two layers, and how it lies and moves. A face lies west (x) or south (y) of its vertex.
template <class Scalar>
struct Level {
    Rows<Scalar> depth, rolling;            // m
    Rows<Scalar> drop_x, drop_y;            // m through each face, that h falls to the east, to the north
    Rows<Scalar> curvature_x, curvature_y;  // of muscl: what makes a drop of second order, m
    Rows<Scalar> slope_dx;                  // m over a cell, slope times Δx
    Rows<Scalar> velocity_x, velocity_y;    // of muscl, m/s; of lax-friedrichs, m more forth and less back
};

template <class Scalar>
struct Work {
    int nx, ny;
    std::array<Border, 4> borders;  // by Side
    Constants<Scalar> c;
    Rows<Scalar> bedrock;
    Level<Scalar> now;   // as the sub-step finds the layers, and leaves them
    Level<Scalar> then;  // of muscl: where they would be at its end

    // What the sub-step moves.
    Rows<Scalar> outflow;         // per metre of drop; of lax-friedrichs, m to each side
    Rows<Scalar> flux_x, flux_y;  // m through each face, to the east, to the north
    Rows<Scalar> exchanged;       // of muscl: m that its first half erodes
    Rows<Scalar> share;           // of muscl: how much of what it wants to give a vertex can

    bool is_ground(int y) const { return y >= 0 && y < ny; }
    bool is_wall(Side side) const { return borders[side] == Border::kWall; }
};

}  // namespace sim::bcre
