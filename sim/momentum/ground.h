#pragma once

#include "sim/momentum/fields.h"
#include "sim/stages/stages.h"

// The ground around a vertex, by central differences:
//
//     NW — N — NE       B_x = (h_E − h_W)/2Δx,  B_y = (h_N − h_S)/2Δx        cos θ = 1/√(1 + |B|²)
//      |   |    |       H_xx: h_E − 2 h_C + h_W over Δx², the mean of three rows by 1 : 2 : 1
//      W — C — E        H_yy: the same of three columns
//      |   |    |       H_xy = (h_NE − h_NW − h_SE + h_SW)/4Δx²
//     SW — S — SE
//
// Forces act along the slope of the ground as it is, h = b + d. Its inclination and its bend are those of the
// smoothed ground, h = b + s (smooth_ground.h): on the raw one a deposit of a few metres on cells of a metre
// would be a wall, and a single sharp vertex would stop a flow.
//
// Bedrock and depth are differenced separately, because their sum would lose the last digits of the layers.

namespace sim::momentum {

template <class S>
struct GroundRow {
    const S *bedrock, *depth;
};
template <class S>
[[gnu::always_inline]] inline GroundRow<S> ground_row(const StageRows<S>& w, const Rows<S>& depth, int y) {
    return {w.bedrock[y], depth[y]};
}

// A row with its neighbours.
template <class S>
struct GroundRows {
    GroundRow<S> south, here, north;
};
template <class S>
[[gnu::always_inline]] inline GroundRows<S> ground_rows(const StageRows<S>& w, const Rows<S>& depth, int y) {
    return {ground_row(w, depth, y - 1), ground_row(w, depth, y), ground_row(w, depth, y + 1)};
}

// h at vertex j of `to` minus h at vertex i of `from`, m.
template <class Number, class S = Scalar<Number>>
[[gnu::always_inline]] inline Number rise(const GroundRow<S>& from, int i, const GroundRow<S>& to, int j) {
    return (at<Number>(to.bedrock, j) - at<Number>(from.bedrock, i)) +
           (at<Number>(to.depth, j) - at<Number>(from.depth, i));
}

template <class Number>
struct Gradient {
    Number x, y;

    Number squared() const { return x * x + y * y; }
};
template <class Number, class S = Scalar<Number>>
[[gnu::always_inline]] inline Gradient<Number> gradient(const GroundRows<S>& rows, int i,
                                                        const Constants<S>& c) {
    return {rise<Number>(rows.here, i - 1, rows.here, i + 1) * c.per_two_cells,
            rise<Number>(rows.south, i, rows.north, i) * c.per_two_cells};
}
template <class Number>
[[gnu::always_inline]] inline Number cosine_of(const Gradient<Number>& b) {
    return Number(1) / sqrt(Number(Number(1) + b.squared()));
}

// Rows of a layer, and its gradient.
template <class S>
struct LayerAround {
    const S *south, *here, *north;
};
template <class S>
[[gnu::always_inline]] inline LayerAround<S> around(const Rows<S>& rows, int y) {
    return {rows[y - 1], rows[y], rows[y + 1]};
}
template <class Number, class S = Scalar<Number>>
[[gnu::always_inline]] inline Gradient<Number> gradient(const LayerAround<S>& rows, int i,
                                                        const Constants<S>& c) {
    return {(at<Number>(rows.here, i + 1) - at<Number>(rows.here, i - 1)) * c.per_two_cells,
            (at<Number>(rows.north, i) - at<Number>(rows.south, i)) * c.per_two_cells};
}
template <class Number>
[[gnu::always_inline]] inline Gradient<Number> operator+(const Gradient<Number>& a,
                                                         const Gradient<Number>& b) {
    return {a.x + b.x, a.y + b.y};
}

// Rises of the surface b + d + R to a vertex from its western and southern neighbour, and from it to the others, m.
template <class Number>
struct Rises {
    Number west, east, south, north;
};
template <class Number, class S = Scalar<Number>>
[[gnu::always_inline]] inline Rises<Number> surface_rises(const GroundRows<S>& ground,
                                                          const LayerAround<S>& rolling, int i) {
    const Number r = at<Number>(rolling.here, i);
    return {rise<Number>(ground.here, i - 1, ground.here, i) + (r - at<Number>(rolling.here, i - 1)),
            rise<Number>(ground.here, i, ground.here, i + 1) + (at<Number>(rolling.here, i + 1) - r),
            rise<Number>(ground.south, i, ground.here, i) + (r - at<Number>(rolling.south, i)),
            rise<Number>(ground.here, i, ground.north, i) + (at<Number>(rolling.north, i) - r)};
}

// Half of the mean of two differences, at most the gentler one (monotonised central, van Leer 1977): exact for a parabola.
template <class Number>
[[gnu::always_inline]] inline Number half_mean_slope(const Number& back, const Number& ahead) {
    return minmod<Number>(Scalar<Number>(0.25) * (back + ahead), minmod(back, ahead));
}

// vᵀ H v, the acceleration by which the ground bends toward (positive) a velocity, m/s².
template <class Number, class S = Scalar<Number>>
[[gnu::always_inline]] inline Number bending(const GroundRows<S>& rows, int i, const Number& u,
                                             const Number& v, const Constants<S>& c) {
    const auto& [south, here, north] = rows;
    const auto along_x = [i](const GroundRow<S>& row) {
        return rise<Number>(row, i, row, i + 1) - rise<Number>(row, i - 1, row, i);
    };
    const auto along_y = [&](int j) {
        return rise<Number>(rows.here, j, rows.north, j) - rise<Number>(rows.south, j, rows.here, j);
    };
    const Number xx = S(2) * along_x(here) + (along_x(south) + along_x(north));
    const Number yy = S(2) * along_y(i) + (along_y(i - 1) + along_y(i + 1));
    const Number xy = rise<Number>(north, i - 1, north, i + 1) - rise<Number>(south, i - 1, south, i + 1);
    return ((xx * (u * u) + yy * (v * v)) + S(2) * xy * (u * v)) * c.per_four_squares;
}

}  // namespace sim::momentum
