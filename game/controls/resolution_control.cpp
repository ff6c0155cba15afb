#include "game/controls/resolution_control.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace game {
namespace {

constexpr double kHold = 0.25;         // s; a hand that drags pauses for less
constexpr double kFits = 0.9;          // of the target; a scale is lowered until a frame takes no more
constexpr double kSpare = 0.92;        // of the target; a scale is raised if a frame would take no more
constexpr int kForgets = 900;          // late frames, until a smaller scale is tried again
constexpr double kLeastDrawing = 0.5;  // of the target belongs to drawing, however long the rest takes

double area_ratio(std::size_t step) {
    const double side = kScales[step] / kScales[step + 1];
    return side * side;
}

// The steps that limits allow: from `first`, the largest scale, to `last`.
struct Steps {
    std::size_t first = 0, last = kScales.size() - 1;
};
Steps allowed(const ResolutionControl::Limits& limits) {
    Steps steps;
    while (steps.first < steps.last && kScales[steps.first] > limits.most) ++steps.first;
    while (steps.last > steps.first && kScales[steps.last] < limits.least) --steps.last;
    return steps;
}

// While the camera stands still.
ResolutionControl::Limits of_world(ResolutionControl::Limits limits) {
    limits.least = limits.least_of_world;
    return limits;
}

}  // namespace

// Until a step is tried: less than in proportion to pixels, because a part of drawing is the same at any size.
ResolutionControl::Ratios ResolutionControl::first_ratio() {
    Ratios ratio{};
    for (std::size_t i = 0; i < ratio.size(); ++i) ratio[i] = std::pow(area_ratio(i), 0.75);
    return ratio;
}

void ResolutionControl::Case::add(double draw_ms, double rest_ms) {
    draw[next] = draw_ms;
    rest[next] = rest_ms;
    next = (next + 1) % kKept;
    size = std::min(size + 1, kKept);
}

double ResolutionControl::Case::median(const std::array<double, kKept>& values, std::size_t last) const {
    std::array<double, kKept> sorted{};
    for (std::size_t i = 0; i < last; ++i) sorted[i] = values[(next + kKept - 1 - i) % kKept];
    const auto middle = sorted.begin() + static_cast<std::ptrdiff_t>(last / 2);
    std::nth_element(sorted.begin(), middle, sorted.begin() + static_cast<std::ptrdiff_t>(last));
    return *middle;
}

double ResolutionControl::Case::expected_ms(std::size_t other, std::size_t last, double target_ms) const {
    double draw_ms = median(draw, last);
    for (std::size_t i = step; i > other; --i) draw_ms *= ratio[i - 1];
    for (std::size_t i = step; i < other; ++i) draw_ms /= ratio[i];
    return draw_ms + std::min(median(rest, last), (1 - kLeastDrawing) * target_ms);
}

void ResolutionControl::Case::change_to(std::size_t other) {
    from = step;
    from_ms = size > 0 ? median(draw, std::min(size, haste)) : 0;
    step = other;
    clear();
}

// Compares the first frames of a step with the last ones of the step before. If several steps lie between, each
// gets its part.
void ResolutionControl::Case::learn() {
    if (!from || size < haste) return;
    const double now_ms = median(draw, haste);
    const std::size_t high = std::min(*from, step), low = std::max(*from, step);
    from.reset();
    if (from_ms <= 0 || now_ms <= 0) return;
    const double found = step == low ? from_ms / now_ms : now_ms / from_ms;
    double expected = 1;
    for (std::size_t i = high; i < low; ++i) expected *= ratio[i];
    const double power = std::log(std::max(found, 1.01)) / std::log(expected);
    for (std::size_t i = high; i < low; ++i)
        ratio[i] = std::clamp(std::pow(ratio[i], power), least_ratio, area_ratio(i));
}

void ResolutionControl::Case::choose(const Limits& limits) {
    const Steps steps = allowed(limits);
    if (step < steps.first || step > steps.last) return change_to(std::clamp(step, steps.first, steps.last));
    learn();
    if (size < haste) return;
    const double target_ms = limits.target_ms;
    if (expected_ms(step, haste, target_ms) > target_ms) {
        std::size_t other = step;
        while (other < steps.last && ratio[other] >= kWorth &&
               expected_ms(other, haste, target_ms) > kFits * target_ms)
            ++other;
        // Fewer pixels that save next to nothing are worse than a late frame.
        while (other == step && size >= patience && other > steps.first && ratio[other - 1] < kWorth) --other;
        if (other != step) return change_to(other);
        if (++late > kForgets) {
            late = 0;
            ratio = first_ratio();
        }
        return;
    }
    if (size < patience) return;
    std::size_t higher = step;
    while (higher > steps.first && expected_ms(higher - 1, patience, target_ms) <= kSpare * target_ms)
        --higher;
    if (higher != step) change_to(higher);
}

// On a screen of another size the old times say what to expect: a window that has become large must not take
// seconds until it is found to be slow.
void ResolutionControl::fit_screen(double pixels) {
    const double before = std::exchange(screen_pixels_, pixels);
    if (before == 0 || before == pixels) return;
    for (Case* each : {&camera_, &world_}) {
        const std::size_t last = std::min(each->size, each->haste);
        const double ms = last > 0 ? each->median(each->draw, last) * pixels / before : 0;
        each->clear();
        each->from.reset();
        if (ms == 0) continue;
        for (std::size_t i = 0; i < each->haste; ++i) each->add(ms, 0);
        each->choose(each == &camera_ ? limits_ : of_world(limits_));
        each->clear();
        each->from.reset();
    }
}

double ResolutionControl::scale_for(const Frame& frame, const Limits& limits) {
    limits_ = limits;
    fit_screen(frame.screen_pixels);
    if (frame.camera_moved) moved_s_ = frame.now_s;
    // For a moment after the camera has moved, the size stays, because the hand may go on.
    const bool camera = frame.camera_moved || frame.now_s - moved_s_ < kHold;
    if (!camera && !std::exchange(world_drawn_, true)) world_.step = camera_.step;
    Case& chosen = camera ? camera_ : world_;
    chosen.choose(camera ? limits : of_world(limits));
    const double scale = kScales[chosen.step];
    // The first frame of a size or of a case pays for the change. What is drawn while the size is held is no
    // frame of either case.
    const bool first = scale != drawn_scale_ || camera != drawn_camera_;
    counts_.reset();
    if (!first && camera == frame.camera_moved) counts_ = camera;
    drawn_scale_ = scale;
    drawn_camera_ = camera;
    return scale;
}

void ResolutionControl::drew(double draw_ms, double other_ms) {
    if (counts_) (*counts_ ? camera_ : world_).add(draw_ms, other_ms);
    counts_.reset();
}

}  // namespace game
