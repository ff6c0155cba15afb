#pragma once

#include <algorithm>
#include <cmath>

#include "sim/layers.h"
#include "sim/scratch.h"

// Faces and their two vertices, along either axis; what the three transport schemes share.
//
//     back      left   |   right     beyond        a face lies between left and right, positive from left to
//     right
//      x-1       x     |    x+1       x+2          (west to east, south to north)

namespace sim::bcre {

// One velocity per face: that of the material on both sides together. 0 where there is none.
template <class Number>
Number face_velocity(Number left_rolling, Number left_velocity, Number right_rolling, Number right_velocity) {
    const Number both = left_rolling + right_rolling;
    return both > 0 ? (left_rolling * left_velocity + right_rolling * right_velocity) / both : 0.f;
}

// Calls flux = face(R_back, R_left, R_right, R_beyond, v_left, v_right) for every face of the rows and stores
// it, in m of depth per unit of Δt/Δx. At the border, where back or beyond would lie outside the halo, the
// halo vertex stands in for it.
template <class Number, class Face>
void each_face(const Layers<Number>& s, Scratch<Number>& scratch, int first, int last, Face&& face) {
    const int nx = s.grid.nx, ny = s.grid.ny;
    for (int y = first; y < last; ++y) {
        const Number *r = s.rolling.row(y), *u = s.velocity_x.row(y);
        Number* flux = scratch.flux_x.row(y);
        flux[-1] = face(r[-1], r[-1], r[0], r[1], u[-1], u[0]);
        for (int x = 0; x < nx - 1; ++x) flux[x] = face(r[x - 1], r[x], r[x + 1], r[x + 2], u[x], u[x + 1]);
        flux[nx - 1] = face(r[nx - 2], r[nx - 1], r[nx], r[nx], u[nx - 1], u[nx]);
    }
    for (int y = first == 0 ? -1 : first; y < last; ++y) {
        const Number *back = s.rolling.row(std::max(y - 1, -1)), *left = s.rolling.row(y);
        const Number *right = s.rolling.row(y + 1), *beyond = s.rolling.row(std::min(y + 2, ny));
        const Number *v_left = s.velocity_y.row(y), *v_right = s.velocity_y.row(y + 1);
        Number* flux = scratch.flux_y.row(y);
        for (int x = 0; x < nx; ++x)
            flux[x] = face(back[x], left[x], right[x], beyond[x], v_left[x], v_right[x]);
    }
}

}  // namespace sim::bcre
