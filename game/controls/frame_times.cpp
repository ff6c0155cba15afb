#include "game/controls/frame_times.h"

#include <algorithm>
#include <numeric>

#include "sim/core/check.h"

namespace game {
namespace {

constexpr float kMeasured = 1000;       // ms
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

std::size_t FrameTimes::recent() const {
    float ms = 0;
    std::size_t count = 0;
    while (count < size_ && ms < kMeasured) ms += (*this)[size_ - 1 - count++].frame_ms;
    return count;
}

double FrameTimes::frames_per_second() const {
    const std::size_t count = recent();
    double ms = 0;
    for (std::size_t i = size_ - count; i < size_; ++i) ms += static_cast<double>((*this)[i].frame_ms);
    return ms >= kLeastMeasured ? static_cast<double>(count) * 1000 / ms : 0;
}

template <class Value>
double FrameTimes::median(const Value& value) const {
    const std::size_t count = recent();
    if (count == 0) return 0;
    std::array<float, kKept> ms;
    for (std::size_t i = 0; i < count; ++i) ms[i] = value((*this)[size_ - count + i]);
    const auto middle = ms.begin() + static_cast<std::ptrdiff_t>(count / 2);
    std::nth_element(ms.begin(), middle, ms.begin() + static_cast<std::ptrdiff_t>(count));
    return static_cast<double>(*middle);
}

double FrameTimes::median_ms(Stage stage) const {
    return median([stage](const FrameTime& frame) { return frame.stage_ms[stage_index(stage)]; });
}

double FrameTimes::median_rest_ms() const {
    return median([](const FrameTime& frame) {
        return std::max(frame.frame_ms - std::accumulate(frame.stage_ms.begin(), frame.stage_ms.end(), 0.f),
                        0.f);
    });
}

float FrameTimes::worst_tick_ms() const {
    float worst = 0;
    for (std::size_t i = size_ - recent(); i < size_; ++i) worst = std::max(worst, (*this)[i].worst_tick_ms);
    return worst;
}

double FrameTimes::ticks_per_frame() const {
    const std::size_t count = recent();
    int ticks = 0;
    for (std::size_t i = size_ - count; i < size_; ++i) ticks += (*this)[i].ticks;
    return count == 0 ? 0 : static_cast<double>(ticks) / static_cast<double>(count);
}

}  // namespace game
