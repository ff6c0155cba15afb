#include "render/pictures/fit.h"

#include <algorithm>

namespace render {
namespace {

// Where pixels of the smaller image begin and end along one axis of the larger one.
std::pair<int, int> covered(int first, int length, int i, int count) {
    const int from = first + static_cast<int>(std::int64_t{length} * i / count),
              to = first + static_cast<int>(std::int64_t{length} * (i + 1) / count);
    return {from, std::max(to, from + 1)};
}

}  // namespace

std::vector<std::uint8_t> fitted(std::span<const std::uint8_t> pixels, const ImageShape& from, int width,
                                 int height) {
    const auto side = [](int of_other, int mine, int other, int most) {
        return static_cast<int>(std::clamp<std::int64_t>(std::int64_t{of_other} * mine / other, 1, most));
    };
    const int wide = side(from.height, width, height, from.width),
              high = side(from.width, height, width, from.height);
    std::vector<std::uint8_t> small;
    small.reserve(static_cast<std::size_t>(width) * static_cast<std::size_t>(height * from.channels));
    for (int y = 0; y < height; ++y) {
        const auto [v0, v1] = covered((from.height - high) / 2, high, y, height);
        for (int x = 0; x < width; ++x) {
            const auto [u0, u1] = covered((from.width - wide) / 2, wide, x, width);
            for (int channel = 0; channel < from.channels; ++channel) {
                std::int64_t sum = 0;
                for (int v = v0; v < v1; ++v)
                    for (int u = u0; u < u1; ++u)
                        sum += pixels[static_cast<std::size_t>(
                            (std::int64_t{v} * from.width + u) * from.channels + channel)];
                small.push_back(static_cast<std::uint8_t>(sum / (std::int64_t{u1 - u0} * (v1 - v0))));
            }
        }
    }
    return small;
}

}  // namespace render
