#include "game/figures/mosaic.h"

#include <algorithm>

#include "sim/core/check.h"

namespace game {

render::Picture mosaic(std::span<const render::Picture> pictures, int columns) {
    CHECK(!pictures.empty() && columns > 0);
    const int width = pictures[0].width, height = pictures[0].height, gap = std::max(2, width / 64);
    const int rows = (static_cast<int>(pictures.size()) + columns - 1) / columns;
    render::Picture whole;
    whole.width = columns * (width + gap) - gap;
    whole.height = rows * (height + gap) - gap;
    whole.pixels.assign(3ul * static_cast<unsigned>(whole.width) * static_cast<unsigned>(whole.height), 255);
    for (std::size_t i = 0; i < pictures.size(); ++i) {
        CHECK(pictures[i].width == width && pictures[i].height == height && pictures[i].channels == 3);
        const int left = static_cast<int>(i) % columns * (width + gap);
        const int top = static_cast<int>(i) / columns * (height + gap);
        for (int y = 0; y < height; ++y)
            std::copy_n(pictures[i].pixels.begin() + 3l * y * width, 3l * width,
                        whole.pixels.begin() + 3l * ((top + y) * whole.width + left));
    }
    return whole;
}

}  // namespace game
