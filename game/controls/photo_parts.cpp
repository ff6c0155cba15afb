#include "game/controls/photo_parts.h"

#include <algorithm>
#include <cmath>

#include "sim/core/check.h"

namespace game {
namespace {

constexpr int kPartStep = render::kPartOverlap;
constexpr int kMostPartsAcross = 64;  // parts along an edge

// The least multiple of the step that makes so many parts of a side.
int inner_side(int side, int parts) {
    const int least = (side + parts - 1) / parts;
    return (least + kPartStep - 1) / kPartStep * kPartStep;
}

}  // namespace

int PhotoParts::rim_of(const std::optional<render::Lens>& lens, int height) {
    const double blur =
        lens && lens->blur > 0 ? render::Lens::kMostBlur * height : 0;  // reaches across the border
    return kPartStep * (1 + static_cast<int>(std::ceil(blur / kPartStep)));
}

std::optional<PhotoParts> PhotoParts::plan(const ScreenSize& screen, int times, int rim,
                                           const ImageBounds& bounds) {
    CHECK(screen.width > 0 && times > 0 && rim % kPartStep == 0);
    PhotoParts plan;
    plan.width_ = times * screen.width, plan.height_ = times * screen.height;
    plan.rim_ = rim;
    for (int parts = times; parts <= kMostPartsAcross; ++parts) {
        plan.inner_width_ = inner_side(plan.width_, parts);
        plan.inner_height_ = inner_side(plan.height_, parts);
        plan.across_ = (plan.width_ + plan.inner_width_ - 1) / plan.inner_width_;
        plan.up_ = (plan.height_ + plan.inner_height_ - 1) / plan.inner_height_;
        const ImageSize frame = plan.frame();
        const int samples = 2 * std::max(frame.width, frame.height);
        if (samples <= bounds.longest_side && bytes_of(frame) <= bounds.most_bytes) return plan;
    }
    return std::nullopt;
}

render::WholeImage PhotoParts::place(int part) const {
    return {width_, height_, part % across_ * inner_width_ - rim_, part / across_ * inner_height_ - rim_};
}

void PhotoParts::put(int part, const render::Picture& frame, render::Picture& photo) const {
    CHECK(photo.width == width_ && photo.height == height_ && frame.width == inner_width_ + 2 * rim_);
    const int left = part % across_ * inner_width_, bottom = part / across_ * inner_height_;
    const int columns = std::min(inner_width_, width_ - left),
              rows = std::min(inner_height_, height_ - bottom);
    for (int row = 0; row < rows; ++row) {  // from the lowest up; images have their top row first
        const std::ptrdiff_t from = static_cast<std::ptrdiff_t>(frame.height - 1 - rim_ - row) * frame.width +
                                    rim_,
                             to = static_cast<std::ptrdiff_t>(height_ - 1 - bottom - row) * width_ + left;
        std::copy_n(frame.pixels.begin() + 3 * from, 3 * static_cast<std::ptrdiff_t>(columns),
                    photo.pixels.begin() + 3 * to);
    }
}

}  // namespace game
