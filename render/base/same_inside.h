#pragma once

#include <cstddef>
#include <cstring>

#include "sim/core/grid.h"

namespace render {

// Whether two fields of one grid have the same values in a row, without their halo. Compares bits.
template <class T>
bool same_row(const sim::Field<T>& a, const sim::Field<T>& b, int y) {
    return std::memcmp(a.row(y), b.row(y), sizeof(T) * static_cast<std::size_t>(a.nx())) == 0;
}

// Whether two fields of one grid have the same values, without their halo. Compares bits, so that a NaN equals itself.
template <class T>
bool same_inside(const sim::Field<T>& a, const sim::Field<T>& b) {
    for (int y = 0; y < a.ny(); ++y) {
        if (!same_row(a, b, y)) return false;
    }
    return true;
}

}  // namespace render
