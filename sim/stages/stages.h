#pragma once

#include <algorithm>
#include <cstdint>

#include "sim/simd/rows.h"
#include "sim/stages/slope.h"
#include "sim/world/outlets.h"
#include "sim/world/params.h"
#include "sim/world/quanta.h"

// The stages that both models have, and how stages are written.
//
// A stage takes what it reads as const and what it writes as not; Rows of a const object cannot be written.
// It is made for a row y and then does its work on vertex or face i of it, for as many as Number has:
// float, double, or lanes. It writes its own row only and reads what earlier stages wrote of this row and its
// neighbours, so rows may be shared out among threads, or follow one another through the stages. Faces are
// one more than vertices, along x and along y; a face lies west or south of the vertex whose number it bears.
// Lanes beyond the end of a row mean nothing; what ends a row is set by end_… when it is done.
//
// All are templates on Number, even those that do not compute with it. They are compiled for instruction sets
// that a machine may lack (sweep/sweep.h), so they must not be shared with other code.

namespace sim {

template <class Number, class S = Scalar<Number>>
[[gnu::always_inline]] inline Number at(const S* row, int i) {
    return load<Number>(row + i);
}

// What is east and west, north and south of vertex i, of values on faces.
template <class Number, class S = Scalar<Number>>
[[gnu::always_inline]] inline Drops<Number> outward(const S* in_x, const S* south, const S* north, int i) {
    return {at<Number>(in_x, i + 1), -at<Number>(in_x, i), at<Number>(north, i), -at<Number>(south, i)};
}

// Rows y = 0 … ny-1, the first and the last for the halo beside them too: what lies beyond the border. Reads
// d, R; writes their halo. Bedrock's halo never changes: it carries the slope on, or mirrors it at a wall.
//   wall   layers and velocity are mirrored: the flow across is zero, and so is the slope
//   open   the standing layer goes on: material leaves over ground that looks like the last cell
//   sink   the world ends in bare bedrock: the edge is a ledge, from which loose material falls
template <class Number, class Work, class State>
void fill_halo(const Work& w, State& u, int y, Span x) {
    using S = Scalar<Number>;
    const auto lies = [](Border border, S beside) { return border == Border::kSink ? S{0} : beside; };
    const auto rolls = [](Border border, S beside) { return border == Border::kWall ? beside : S{0}; };
    S *d = u.depth[y], *r = u.rolling[y];
    if (x.first == 0) {
        d[-1] = lies(w.borders[kWest], d[0]);
        r[-2] = r[-1] = rolls(w.borders[kWest], r[0]);  // −2: that muscl sees it go on level
    }
    if (x.last == w.nx) {
        d[w.nx] = lies(w.borders[kEast], d[w.nx - 1]);
        r[w.nx + 1] = r[w.nx] = rolls(w.borders[kEast], r[w.nx - 1]);
    }
    const auto beyond = [&](Side side, int row) {
        S *d_beyond = u.depth[row], *r_beyond = u.rolling[row];
        for (int i = x.first; i < x.last; ++i) {
            d_beyond[i] = lies(w.borders[side], d[i]);
            r_beyond[i] = rolls(w.borders[side], r[i]);
        }
    };
    if (y == 0) beyond(kSouth, -1);
    if (y == w.ny - 1) beyond(kNorth, w.ny);
}

// Faces y = 0 … ny. Reads b, d; writes drop_x, drop_y.
template <class Number, class Work, class State, class S = Scalar<Number>>
auto find_drops(const Work& w, const State& u, Rows<S>& to_x, Rows<S>& to_y, int y) {
    return [b = w.bedrock[y], b_south = w.bedrock[y - 1], d = u.depth[y], d_south = u.depth[y - 1],
            drop_x = to_x[y], drop_y = to_y[y]](int i) {
        const Number bed = at<Number>(b, i), lies = at<Number>(d, i);
        store<Number>((at<Number>(b, i - 1) - bed) + (at<Number>(d, i - 1) - lies), drop_x + i);
        store<Number>((at<Number>(b_south, i) - bed) + (at<Number>(d_south, i) - lies), drop_y + i);
    };
}

// The curvature correction, for second order: faces y = 0 … ny. Reads drop_x, drop_y; writes curvature_x,
// curvature_y. Beyond the halo h continues linearly.
template <class Number, class Work, class S = Scalar<Number>>
void end_drops(const Work& w, Rows<S>& drop_x, int y) {
    S* drop = drop_x[y];
    drop[-1] = drop[0], drop[w.nx + 1] = drop[w.nx];
}
template <class Number, class Work, class State, class S = Scalar<Number>>
auto find_curvature(const Work& w, const State& u, Rows<S>& to_x, Rows<S>& to_y, int y) {
    return [drop_x = u.drop_x[y], drop_y = u.drop_y[y], south = u.drop_y[std::max(y - 1, 0)],
            north = u.drop_y[std::min(y + 1, w.ny)], curvature_x = to_x[y], curvature_y = to_y[y]](int i) {
        store(
            curvature_correction(at<Number>(drop_x, i - 1), at<Number>(drop_x, i), at<Number>(drop_x, i + 1)),
            curvature_x + i);
        store(curvature_correction(at<Number>(south, i), at<Number>(drop_y, i), at<Number>(north, i)),
              curvature_y + i);
    };
}
// Removes material that flowed into no-data. Rows y = 0 … ny-1; writes d, R, and velocity if it is state.
template <class Number, class State>
void clear_drains(State& u, const Outlets::View& outlets, int y, Span x) {
    Scalar<Number>*d = u.depth[y], *r = u.rolling[y];
    for (int i = outlets.first_drain[y]; i < outlets.first_drain[y + 1]; ++i) {
        const int drain = outlets.drains[i];
        if (drain < x.first || drain >= x.last) continue;
        d[drain] = r[drain] = 0;
        if constexpr (requires { State::kVelocityIsState; })
            u.velocity_x[y][drain] = u.velocity_y[y][drain] = 0;
    }
}

// The outflow from row y out of the world, in quanta, within the vertices of x. Reads flux_x, flux_y,
// quantised.
template <class Number, class Fluxes>
std::int64_t drained(const Fluxes& through, const Outlets::View& outlets, int y, Span x) {
    std::int64_t quanta = 0;
    for (int i = outlets.first_face[y]; i < outlets.first_face[y + 1]; ++i) {
        const auto [at, row, way] = outlets.faces[i];
        if (at < x.first || at >= x.last) continue;
        const float out = way == Way::kEast    ? through.flux_x[y][at + 1]
                          : way == Way::kWest  ? -through.flux_x[y][at]
                          : way == Way::kNorth ? through.flux_y[y + 1][at]
                                               : -through.flux_y[y][at];
        quanta += static_cast<std::int64_t>(out / kQuantum);
    }
    return quanta;
}

}  // namespace sim
