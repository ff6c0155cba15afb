#include "game/controls/frame_times.h"

#include <algorithm>

#include "sim/core/check.h"

namespace game {
namespace {

constexpr double kLeastMeasured = 100;  // ms; one frame is no rate, least of all the first

}  // namespace

void FrameTimes::add(const FrameTime& frame) {
    frames_[next_] = frame;
    next_ = (next_ + 1) % kKept;
    size_ = std::min(size_ + 1, kKept);
}

const FrameTime& FrameTimes::operator[](std::size_t i) const {
    CHECK(i < size_);
    return frames_[(next_ + kKept - size_ + i) % kKept];
}

double FrameTimes::frames_per_second() const {
    double ms = 0;
    std::size_t count = 0;
    for (; count < size_ && ms < 1000; ++count)
        ms += static_cast<double>((*this)[size_ - 1 - count].frame_ms);
    return ms >= kLeastMeasured ? static_cast<double>(count) * 1000 / ms : 0;
}

double FrameTimes::median_ms(Stage stage) const {
    if (size_ == 0) return 0;
    std::array<float, kKept> ms;
    for (std::size_t i = 0; i < size_; ++i) ms[i] = (*this)[i].stage_ms[stage_index(stage)];
    const auto middle = ms.begin() + static_cast<std::ptrdiff_t>(size_ / 2);
    std::nth_element(ms.begin(), middle, ms.begin() + static_cast<std::ptrdiff_t>(size_));
    return static_cast<double>(*middle);
}

float FrameTimes::worst_tick_ms() const {
    float worst = 0;
    for (std::size_t i = 0; i < size_; ++i) worst = std::max(worst, (*this)[i].worst_tick_ms);
    return worst;
}

}  // namespace game
