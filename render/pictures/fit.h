#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace render {

// The size of an image whose rows follow each other.
struct ImageShape {
    int width = 0, height = 0;  // px, at least 1
    int channels = 3;           // of 8 bits
};

// The middle of an image in another shape, as much of it as fits, each pixel the mean of what it covers.
std::vector<std::uint8_t> fitted(std::span<const std::uint8_t> pixels, const ImageShape& from, int width,
                                 int height);

}  // namespace render
