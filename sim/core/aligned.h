#pragma once

#include <cstddef>
#include <new>
#include <vector>

namespace sim {

// Allocates memory that starts on a cache line, because lanes that span two lines cost twice.
inline constexpr std::size_t kCacheLine = 64;  // bytes

template <class T>
struct AlignedAllocator {
    using value_type = T;

    AlignedAllocator() = default;
    template <class U>
    AlignedAllocator(const AlignedAllocator<U>&) {}

    T* allocate(std::size_t count) {
        return static_cast<T*>(::operator new (count * sizeof(T), std::align_val_t{kCacheLine}));
    }
    void deallocate(T* at, std::size_t) { ::operator delete (at, std::align_val_t{kCacheLine}); }

    bool operator==(const AlignedAllocator&) const = default;
};

template <class T>
using AlignedVector = std::vector<T, AlignedAllocator<T>>;

}  // namespace sim
