#include "render/flow/powder_tiles.h"

#include <algorithm>
#include <cmath>

namespace render {
namespace {

constexpr int kPowderTile =
    64;  // samples along an edge: a block of the software renderer, which shades whole ones fastest
constexpr float kBeside = 9;  // samples around an ellipse: one and a half of the coarsest pixels

}  // namespace

void PowderTiles::begin(int width, int height) {
    if (width != width_ || height != height_) {
        width_ = width;
        height_ = height;
        columns_ = (width + kPowderTile - 1) / kPowderTile;
        rows_ = (height + kPowderTile - 1) / kPowderTile;
        tiles_.resize(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_));
        rectangles_.reserve(tiles_.size());
    }
    std::fill(tiles_.begin(), tiles_.end(), std::uint8_t{0});
}

void PowderTiles::add(glm::vec2 middle, glm::vec2 half) {
    constexpr float kSide = kPowderTile;
    const glm::vec2 size(width_, height_);
    const glm::vec2 at = (0.5f + 0.5f * middle) * size, reach = 0.5f * half * size + kBeside;
    const int bottom = static_cast<int>(std::max((at.y - reach.y) / kSide, 0.f)),
              top = static_cast<int>(std::min((at.y + reach.y) / kSide, static_cast<float>(rows_ - 1)));
    for (int row = bottom; row <= top; ++row) {
        // The row's place that is nearest to the middle has the widest part of the ellipse.
        const float low = kSide * static_cast<float>(row);
        const float off = (std::clamp(at.y, low, low + kSide) - at.y) / reach.y;
        const float wide = reach.x * std::sqrt(std::max(1 - off * off, 0.f));
        const float left = (at.x - wide) / kSide, right = (at.x + wide) / kSide;
        if (right < 0 || left >= static_cast<float>(columns_)) continue;
        const auto begin = tiles_.begin() + static_cast<std::ptrdiff_t>(row) * columns_;
        std::fill(begin + static_cast<int>(std::max(left, 0.f)),
                  begin + std::min(static_cast<int>(right), columns_ - 1) + 1, std::uint8_t{1});
    }
}

std::span<const Rectangle> PowderTiles::collect() {
    rectangles_.clear();
    for (int row = 0; row < rows_; ++row) {
        const auto begin = tiles_.begin() + static_cast<std::ptrdiff_t>(row) * columns_,
                   end = begin + columns_;
        for (auto first = std::find(begin, end, 1); first != end;) {
            const auto last = std::find(first, end, 0);
            rectangles_.push_back({static_cast<int>(first - begin) * kPowderTile, row * kPowderTile,
                                   std::min(static_cast<int>(last - begin) * kPowderTile, width_),
                                   std::min((row + 1) * kPowderTile, height_)});
            first = std::find(last, end, 1);
        }
    }
    return rectangles_;
}

}  // namespace render
