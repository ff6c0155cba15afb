#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <utility>

// The part of the standard's data-parallel types (std::experimental::simd, Parallelism TS 2) that formulas here use, on
// clang's vectors: for a standard library without them, which libc++ is. Names and meaning are the standard's; every
// operation is one IEEE operation per lane, so lanes have the same bits with either.

// NOLINTBEGIN(readability-identifier-naming): the standard's names.
namespace sim::vectors {

#define COULOIR_INLINE [[gnu::always_inline]]

struct element_aligned_tag {};
inline constexpr element_aligned_tag element_aligned{};

namespace simd_abi {
template <int kLanes>
struct Lanes {};
template <class T, std::size_t kLanes>
using deduce_t = Lanes<static_cast<int>(kLanes)>;
template <class T>
using native = Lanes<static_cast<int>(16 / sizeof(T))>;
}  // namespace simd_abi

template <class T, class Abi>
class simd_mask;
template <class T, class Abi>
class simd;

template <class T, int kLanes>
class simd_mask<T, simd_abi::Lanes<kLanes>> {
  public:
    using Bits = std::conditional_t<sizeof(T) == 4, std::int32_t, std::int64_t>;
    static_assert(sizeof(T) == sizeof(Bits));
    using Vector [[gnu::vector_size(sizeof(T) * kLanes)]] = Bits;
    static constexpr std::size_t size() { return kLanes; }

    simd_mask() = default;
    COULOIR_INLINE explicit simd_mask(Vector lanes) : v(lanes) {}
    COULOIR_INLINE simd_mask(bool all) : v(Vector{} - Bits{all}) {}
    COULOIR_INLINE bool operator[](std::size_t i) const { return v[i] != 0; }
    COULOIR_INLINE simd_mask operator!() const { return simd_mask(~v); }
#define COULOIR_BOTH(op, of)                                                              \
    COULOIR_INLINE friend simd_mask operator op(const simd_mask& a, const simd_mask& b) { \
        return simd_mask(of);                                                             \
    }
    COULOIR_BOTH(&&, a.v& b.v)
    COULOIR_BOTH(||, a.v | b.v)
    COULOIR_BOTH(&, a.v& b.v)
    COULOIR_BOTH(|, a.v | b.v)
    COULOIR_BOTH(^, a.v ^ b.v)
    COULOIR_BOTH(==, ~(a.v ^ b.v))
    COULOIR_BOTH(!=, a.v ^ b.v)
#undef COULOIR_BOTH
    Vector v;  // all bits of a lane, or none
};

template <class T, int kLanes>
class simd<T, simd_abi::Lanes<kLanes>> {
  public:
    using value_type = T;
    using abi_type = simd_abi::Lanes<kLanes>;
    using mask_type = simd_mask<T, abi_type>;
    using Vector [[gnu::vector_size(sizeof(T) * kLanes)]] = T;
    using Unaligned [[gnu::vector_size(sizeof(T) * kLanes), gnu::aligned(alignof(T)), gnu::may_alias]] = T;
    static constexpr std::size_t size() { return kLanes; }

    simd() = default;
    COULOIR_INLINE explicit simd(Vector lanes) : v(lanes) {}
    template <class U>
    requires std::is_arithmetic_v<U> COULOIR_INLINE simd(U all) {
        for (int i = 0; i < kLanes; ++i) v[i] = static_cast<T>(all);
    }
    COULOIR_INLINE simd(const T* from, element_aligned_tag) : v(*reinterpret_cast<const Unaligned*>(from)) {}
    // make(std::integral_constant<std::size_t, i>()) for each lane.
    template <class Make>
    requires std::is_invocable_v<Make, std::integral_constant<std::size_t, 0>> COULOIR_INLINE explicit simd(
        Make&& make) {
        [&]<std::size_t... i>(std::index_sequence<i...>) {
            ((v[i] = static_cast<T>(make(std::integral_constant<std::size_t, i>()))), ...);
        }
        (std::make_index_sequence<kLanes>());
    }
    COULOIR_INLINE void copy_to(T* to, element_aligned_tag) const { *reinterpret_cast<Unaligned*>(to) = v; }
    COULOIR_INLINE T operator[](std::size_t i) const { return v[i]; }

    COULOIR_INLINE simd operator-() const { return simd(-v); }
    COULOIR_INLINE simd operator~() const { return simd(~v); }
#define COULOIR_BOTH(op)                                                   \
    COULOIR_INLINE friend simd operator op(const simd& a, const simd& b) { \
        return simd(a.v op b.v);                                           \
    }                                                                      \
    COULOIR_INLINE friend simd& operator op##=(simd& a, const simd& b) {   \
        return a = simd(a.v op b.v);                                       \
    }
    COULOIR_BOTH(+)
    COULOIR_BOTH(-)
    COULOIR_BOTH(*)
    COULOIR_BOTH(/)
    COULOIR_BOTH(&)
    COULOIR_BOTH(|)
    COULOIR_BOTH(^)
#undef COULOIR_BOTH
    COULOIR_INLINE friend simd operator<<(const simd& a, int bits) {
        return simd(a.v << bits);
    }
    COULOIR_INLINE friend simd operator>>(const simd& a, int bits) {
        return simd(a.v >> bits);
    }
#define COULOIR_COMPARED(op)                                                    \
    COULOIR_INLINE friend mask_type operator op(const simd& a, const simd& b) { \
        return mask_type(a.v op b.v);                                           \
    }
    COULOIR_COMPARED(<)
    COULOIR_COMPARED(>)
    COULOIR_COMPARED(<=)
    COULOIR_COMPARED(>=)
    COULOIR_COMPARED(==)
    COULOIR_COMPARED(!=)
#undef COULOIR_COMPARED
    Vector v;
};

template <class T>
inline constexpr bool is_simd_v = false;
template <class T, class Abi>
inline constexpr bool is_simd_v<simd<T, Abi>> = true;
template <class T>
using native_simd = simd<T, simd_abi::native<T>>;
template <class T, class Simd>
using rebind_simd_t = simd<T, simd_abi::Lanes<static_cast<int>(Simd::size())>>;

template <class To, class T, class Abi>
COULOIR_INLINE inline To static_simd_cast(const simd<T, Abi>& a) {
    return To(__builtin_convertvector(a.v, typename To::Vector));
}

// As std::max and std::min: of equal ones, and beside a NaN, the first.
template <class T, class Abi>
COULOIR_INLINE inline simd<T, Abi> max(const simd<T, Abi>& a, const simd<T, Abi>& b) {
    return simd<T, Abi>(a.v < b.v ? b.v : a.v);
}
template <class T, class Abi>
COULOIR_INLINE inline simd<T, Abi> min(const simd<T, Abi>& a, const simd<T, Abi>& b) {
    return simd<T, Abi>(b.v < a.v ? b.v : a.v);
}
template <class T, class Abi>
COULOIR_INLINE inline simd<T, Abi> abs(const simd<T, Abi>& a) {
    return simd<T, Abi>(__builtin_elementwise_abs(a.v));
}
template <class T, class Abi>
COULOIR_INLINE inline simd<T, Abi> sqrt(const simd<T, Abi>& a) {
    return simd<T, Abi>(__builtin_elementwise_sqrt(a.v));
}
template <class T, class Abi>
COULOIR_INLINE inline simd<T, Abi> floor(const simd<T, Abi>& a) {
    return simd<T, Abi>(__builtin_elementwise_floor(a.v));
}
template <class T, class Abi>
COULOIR_INLINE inline T reduce(const simd<T, Abi>& a) {
    T sum = a[0];
    for (std::size_t i = 1; i < a.size(); ++i) sum += a[i];
    return sum;
}

template <class T, class Abi>
COULOIR_INLINE inline bool any_of(const simd_mask<T, Abi>& mask) {
    return __builtin_reduce_or(mask.v) != 0;
}
template <class T, class Abi>
COULOIR_INLINE inline bool all_of(const simd_mask<T, Abi>& mask) {
    return __builtin_reduce_and(mask.v) != 0;
}
template <class T, class Abi>
COULOIR_INLINE inline bool none_of(const simd_mask<T, Abi>& mask) {
    return !any_of(mask);
}
template <class T, class Abi>
COULOIR_INLINE inline int popcount(const simd_mask<T, Abi>& mask) {
    return static_cast<int>(-__builtin_reduce_add(mask.v));
}

// where(mask, to) = from: in the lanes of the mask.
template <class T, class Abi>
class where_expression {
  public:
    COULOIR_INLINE where_expression(const simd_mask<T, Abi>& mask, simd<T, Abi>& to) : mask_(mask), to_(to) {}
    COULOIR_INLINE void operator=(const simd<T, Abi>& from) && { to_.v = mask_.v ? from.v : to_.v; }

  private:
    const simd_mask<T, Abi>& mask_;
    simd<T, Abi>& to_;
};
template <class T, class Abi>
COULOIR_INLINE inline where_expression<T, Abi> where(const simd_mask<T, Abi>& mask, simd<T, Abi>& to) {
    return {mask, to};
}

#undef COULOIR_INLINE

}  // namespace sim::vectors
// NOLINTEND(readability-identifier-naming)
