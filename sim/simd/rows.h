#pragma once

#include <cstddef>
#include <limits>

#include "sim/core/grid.h"
#include "sim/simd/numbers.h"

// A step consists of stages that work on one row at a time. Stages only know where the rows are: the plain
// step gives them whole fields, a sweep the few rows that it keeps.

namespace sim {

// Rows of values; row y begins at [y] with x = 0. Those of a const Rows can only be read, so that the
// signature of a stage says what it writes.
template <class Scalar>
class Rows {
  public:
    Rows() = default;

    // All rows of a field.
    explicit Rows(Field<Scalar>& field) : Rows(field.row(0), field.stride()) {}
    Rows(Scalar* row_0, std::ptrdiff_t stride) : first_(row_0), stride_(stride) {}

    // A ring of the last `count` rows, a power of two: row y replaces row y − count.
    Rows(Scalar* first, std::ptrdiff_t stride, int count)
        : first_(first), stride_(stride), within_(count - 1) {}

    // The same rows, except that those below `from` and those from `to` on are stored elsewhere.
    Rows beside(int from, Scalar* below, int to, Scalar* above) const {
        Rows rows = *this;
        rows.from_ = from, rows.to_ = to, rows.below_ = below, rows.above_ = above;
        return rows;
    }

    [[gnu::always_inline]] const Scalar* operator[](int y) const { return row(y); }
    [[gnu::always_inline]] Scalar* operator[](int y) { return row(y); }

  private:
    [[gnu::always_inline]] Scalar* row(int y) const {
        if (y < from_) return below_ + (y - from_) * stride_;
        if (y >= to_) return above_ + (y - to_) * stride_;
        return first_ + (y & within_) * stride_;
    }

    Scalar* first_ = nullptr;
    std::ptrdiff_t stride_ = 0;
    int within_ = -1;
    int from_ = std::numeric_limits<int>::min(), to_ = std::numeric_limits<int>::max();
    Scalar *below_ = nullptr, *above_ = nullptr;  // where rows from_ and to_ would be
};

// Vertices first … last-1 of a row.
struct Span {
    int first, last;

    Span faces() const { return {first, last + 1}; }
};

template <class Number>
inline constexpr int kLanes = 1;
template <class T, class Abi>
inline constexpr int kLanes<stdx::simd<T, Abi>> = static_cast<int>(stdx::simd<T, Abi>::size());

// Applies stages to each vertex of a row, one vector of lanes at a time. The last lanes may extend into the
// row's padding. The loop copies the stages, so that their writes cannot alias the numbers that they use,
// which stay in registers.
template <class Number, class... Stages>
[[gnu::flatten, gnu::noinline]] void along(Span x, const Stages&... stages) {
    [x](Stages... own) {
        for (int i = x.first; i < x.last; i += kLanes<Number>) (own(i), ...);
    }(stages...);
}

// The analyser mistakes a row that a stage holds but does not read for one that it reads.
template <class Number>
[[gnu::always_inline]] inline Number load(const Scalar<Number>* from) {
    if constexpr (kIsLanes<Number>) {
        using Vector [[gnu::vector_size(sizeof(Number))]] = float;
        using Unaligned [[gnu::vector_size(sizeof(Number)), gnu::aligned(4), gnu::may_alias]] = float;
        // NOLINTNEXTLINE(clang-analyzer-core.NullDereference)
        return Number(static_cast<Vector>(*reinterpret_cast<const Unaligned*>(from)));
    } else {
        return *from;  // NOLINT(clang-analyzer-core.NullDereference)
    }
}

template <class Number>
[[gnu::always_inline]] inline void store(const Number& value, Scalar<Number>* to) {
    if constexpr (kIsLanes<Number>)
        value.copy_to(to, stdx::element_aligned);
    else
        *to = value;
}

// 0 in the lanes from `end` on, so that they do not ask for more work than the lanes before.
template <class Number>
[[gnu::always_inline]] inline Number only_before(int end, const Number& value, int x) {
    if constexpr (kIsLanes<Number>) {
        if (x + kLanes < Number >> end) return select(first_lanes<Number>(end - x), value, Number(0));
    }
    return value;
}

// Stores only the lanes before `end`: for rows that others read beyond it.
template <class Number>
[[gnu::always_inline]] inline void store_before(int end, const Number& value, Scalar<Number>* row, int x) {
    if constexpr (kIsLanes<Number>) {
        if (x + kLanes < Number >> end) {
            store(select(first_lanes<Number>(end - x), value, load<Number>(row + x)), row + x);
            return;
        }
    }
    store(value, row + x);
}

}  // namespace sim
