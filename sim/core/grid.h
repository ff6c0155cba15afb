#pragma once

#include <algorithm>
#include <cstddef>

#include "sim/core/aligned.h"
#include "sim/core/check.h"

namespace sim {

// A regular grid of vertices. x runs east, y runs north, row 0 is the south. A grid of N×N squares has (N+1)²
// vertices. Every vertex owns a full cell of dx² m², including those on the border.
struct Grid {
    int nx = 0;      // vertices along x, ≥ 3
    int ny = 0;      // vertices along y, ≥ 3
    float dx = 1.f;  // spacing, m, > 0

    std::size_t size() const { return static_cast<std::size_t>(nx) * static_cast<std::size_t>(ny); }
    double cell_area() const { return static_cast<double>(dx) * dx; }  // m²
    bool contains(int x, int y) const { return x >= 0 && y >= 0 && x < nx && y < ny; }
    bool operator==(const Grid&) const = default;
};

// Row padding, so that several lanes can be read from any vertex of a row.
inline constexpr int kRowPadding = 16;

// One value per vertex, with a halo of one vertex, so that a stencil needs no special case at the border.
// Row-major, x fastest; (x, y) is valid from -1 to nx and from -1 to ny. Starts at zero.
template <class T>
class Field {
  public:
    Field() = default;
    explicit Field(const Grid& grid)
        : nx_(grid.nx),
          ny_(grid.ny),
          stride_((grid.nx / kRowPadding + 3) * kRowPadding),
          values_(static_cast<std::size_t>(stride_) * static_cast<std::size_t>(grid.ny + 2)) {}

    int nx() const { return nx_; }
    int ny() const { return ny_; }
    int stride() const { return stride_; }  // from one row to the next

    // Pointer to x = 0 of a row; [-1] and [nx] are the halo.
    T* row(int y) { return values_.data() + offset(0, y); }
    const T* row(int y) const { return values_.data() + offset(0, y); }

    T& operator()(int x, int y) { return values_[offset(x, y)]; }
    const T& operator()(int x, int y) const { return values_[offset(x, y)]; }

    void fill(T value) { std::fill(values_.begin(), values_.end(), value); }

  private:
    std::size_t offset(int x, int y) const {
        CHECK(x >= -1 && x <= nx_ && y >= -1 && y <= ny_);
        return static_cast<std::size_t>(y + 1) * static_cast<std::size_t>(stride_) +
               static_cast<std::size_t>(x + kRowPadding);
    }

    int nx_ = 0, ny_ = 0, stride_ = 0;
    AlignedVector<T> values_;  // whole cache lines; x = 0 starts one
};

}  // namespace sim
