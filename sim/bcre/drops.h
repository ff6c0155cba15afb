#pragma once

#include "sim/bcre/slope.h"
#include "sim/layers.h"

// Where the differences of h that slope.h speaks of come from: the layers' fields, one vertex at a time. The
// halo takes part; what lies beyond it is not known.

namespace sim::bcre {

// h at one vertex less h at another, m.
template <class Number>
Number rise(const Layers<Number>& s, int from_x, int from_y, int to_x, int to_y) {
    return (s.bedrock(to_x, to_y) - s.bedrock(from_x, from_y)) +
           (s.depth(to_x, to_y) - s.depth(from_x, from_y));
}

// B, the bend of h along x or y; 0 where a neighbour lies beyond the halo.
template <class Number>
Number bend_x(const Layers<Number>& s, int x, int y) {
    return x < 0 || x >= s.grid.nx ? Number{0} : rise(s, x, y, x + 1, y) - rise(s, x - 1, y, x, y);
}
template <class Number>
Number bend_y(const Layers<Number>& s, int x, int y) {
    return y < 0 || y >= s.grid.ny ? Number{0} : rise(s, x, y, x, y + 1) - rise(s, x, y - 1, x, y);
}

// D toward the four neighbours, m.
template <class Number>
Drops<Number> drops(const Layers<Number>& s, int x, int y) {
    return {rise(s, x + 1, y, x, y), rise(s, x - 1, y, x, y), rise(s, x, y + 1, x, y),
            rise(s, x, y - 1, x, y)};
}

// The same to second order, from those of first order.
template <class Number>
Drops<Number> limited_drops(const Layers<Number>& s, const Drops<Number>& drop, int x, int y) {
    constexpr Number kHalf = 0.5f;
    const Number along_x = bend_x(s, x, y), along_y = bend_y(s, x, y);
    return {drop.east + kHalf * minmod(along_x, bend_x(s, x + 1, y)),
            drop.west + kHalf * minmod(along_x, bend_x(s, x - 1, y)),
            drop.north + kHalf * minmod(along_y, bend_y(s, x, y + 1)),
            drop.south + kHalf * minmod(along_y, bend_y(s, x, y - 1))};
}

}  // namespace sim::bcre
