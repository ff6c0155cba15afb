#pragma once

#include "sim/stages/stages.h"
#include "sim/voellmy/fields.h"

// The ground h = b + d around a vertex, by central differences:
//
//     NW — N — NE       B_x = (h_E − h_W)/2Δx,  B_y = (h_N − h_S)/2Δx        cos θ = 1/√(1 + |B|²)
//      |   |    |       H_xx: h_E − 2 h_C + h_W over Δx², the mean of three rows by 1 : 2 : 1
//      W — C — E        H_yy: the same of three columns
//      |   |    |       H_xy = (h_NE − h_NW − h_SE + h_SW)/4Δx²
//     SW — S — SE
//
// Bedrock and depth are differenced separately, because their sum would lose the last digits of the layers.

namespace sim::voellmy {

template <class S>
struct GroundRow {
    const S *bedrock, *depth;
};
template <class S>
[[gnu::always_inline]] inline GroundRow<S> ground_row(const StageRows<S>& w, int y) {
    return {w.bedrock[y], w.u0.depth[y]};
}

// h at vertex j of `to` minus h at vertex i of `from`, m.
template <class Number, class S = Scalar<Number>>
[[gnu::always_inline]] inline Number rise(const GroundRow<S>& from, int i, const GroundRow<S>& to, int j) {
    return (at<Number>(to.bedrock, j) - at<Number>(from.bedrock, i)) +
           (at<Number>(to.depth, j) - at<Number>(from.depth, i));
}

// Rows y = 0 … ny-1. Reads b, d, R; writes slope_x, slope_y and cosine, where the layer or a neighbour rolls.
template <class Number, class S = Scalar<Number>>
auto find_ground(const StageRows<S>& w, Fields<Rows<S>>& to, int y) {
    return [c = w.c, south = ground_row(w, y - 1), here = ground_row(w, y), north = ground_row(w, y + 1),
            r_south = w.u0.rolling[y - 1], r_here = w.u0.rolling[y], r_north = w.u0.rolling[y + 1],
            slope_x = to.slope_x[y], slope_y = to.slope_y[y], cosine = to.cosine[y]](int i) {
        const Number across = max(at<Number>(r_here, i - 1), at<Number>(r_here, i + 1));
        const Number along = max(at<Number>(r_south, i), at<Number>(r_north, i));
        if (!any(max(max(across, along), at<Number>(r_here, i)) > S{0})) return;
        const Number bx = rise<Number>(here, i - 1, here, i + 1) * c.per_two_cells;
        const Number by = rise<Number>(south, i, north, i) * c.per_two_cells;
        store(bx, slope_x + i), store(by, slope_y + i);
        store<Number>(Number(1) / sqrt(Number(1) + (bx * bx + by * by)), cosine + i);
    };
}
// Beyond the border the ground is level; nothing that arrives there is seen again. Rows y = -1 … ny.
template <class Number, class S = Scalar<Number>>
void end_ground(const StageRows<S>& w, Fields<Rows<S>>& to, int y, Span x) {
    S *slope_x = to.slope_x[y], *slope_y = to.slope_y[y], *cosine = to.cosine[y];
    const auto level = [&](int i) { slope_x[i] = slope_y[i] = 0, cosine[i] = 1; };
    if (w.is_ground(y))
        level(-1), level(w.nx);
    else
        for (int i = x.first; i < x.last; ++i) level(i);
}

// vᵀ H v, the acceleration by which the ground bends toward (positive) a velocity, m/s².
template <class Number, class S = Scalar<Number>>
[[gnu::always_inline]] inline Number bending(const GroundRow<S>& south, const GroundRow<S>& here,
                                             const GroundRow<S>& north, int i, const Number& u,
                                             const Number& v, const Constants<S>& c) {
    const auto along_x = [i](const GroundRow<S>& row) {
        return rise<Number>(row, i, row, i + 1) - rise<Number>(row, i - 1, row, i);
    };
    const auto along_y = [&](int j) {
        return rise<Number>(here, j, north, j) - rise<Number>(south, j, here, j);
    };
    const Number xx = S(2) * along_x(here) + (along_x(south) + along_x(north));
    const Number yy = S(2) * along_y(i) + (along_y(i - 1) + along_y(i + 1));
    const Number xy = rise<Number>(north, i - 1, north, i + 1) - rise<Number>(south, i - 1, south, i + 1);
    return ((xx * (u * u) + yy * (v * v)) + S(2) * xy * (u * v)) * c.per_four_squares;
}

}  // namespace sim::voellmy
