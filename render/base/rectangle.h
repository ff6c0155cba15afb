#pragma once

#include <algorithm>

namespace render {

// Part of a frame, in samples from its lower left corner. Empty unless left < right and bottom < top.
struct Rectangle {
    int left = 0, bottom = 0, right = 0, top = 0;
    bool operator==(const Rectangle&) const = default;

    bool empty() const { return left >= right || bottom >= top; }
    int width() const { return right - left; }
    int height() const { return top - bottom; }
    bool meets(const Rectangle& other) const {
        return left < other.right && other.left < right && bottom < other.top && other.bottom < top;
    }
};

inline Rectangle common_part(const Rectangle& a, const Rectangle& b) {
    return {std::max(a.left, b.left), std::max(a.bottom, b.bottom), std::min(a.right, b.right),
            std::min(a.top, b.top)};
}

// The smallest one around both; an empty one has no place.
inline Rectangle around_both(const Rectangle& a, const Rectangle& b) {
    if (a.empty()) return b;
    if (b.empty()) return a;
    return {std::min(a.left, b.left), std::min(a.bottom, b.bottom), std::max(a.right, b.right),
            std::max(a.top, b.top)};
}

inline Rectangle grown(const Rectangle& r, int by) {
    return {r.left - by, r.bottom - by, r.right + by, r.top + by};
}

}  // namespace render
