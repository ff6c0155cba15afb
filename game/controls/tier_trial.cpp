#include "game/controls/tier_trial.h"

#include <algorithm>
#include <array>
#include <utility>

namespace game {
namespace {

constexpr int kDraws = 2;               // of each image; the faster one counts
constexpr double kMostSpent = 500;      // ms
constexpr double kDrawingShare = 0.75;  // of the target; the rest is for ticks and panels
constexpr double kHopeless = 4;         // times too slow; then there is no second draw
constexpr double kNextCosts = 1.25;     // at least, times this image; else the next is not tried

// The least that each tier needs, in order.
struct Trial {
    TierTrial::Image image;
    Tier tier;       // if it is in time
    double samples;  // per pixel of the screen
};
constexpr std::array<Trial, 3> kTrials{{{{0.5, false}, Tier::kFast, 0.25},
                                        {{0.75, false}, Tier::kBalanced, 0.5625},
                                        {{1, true}, Tier::kFull, 4}}};

}  // namespace

TierTrial::Image TierTrial::image() const {
    return kTrials[std::min(image_, kTrials.size() - 1)].image;
}

void TierTrial::drew(double ms) {
    if (result_) return;
    if (!std::exchange(warm_, true)) return;
    least_ms_ = draws_ == 0 ? ms : std::min(least_ms_, ms);
    spent_ms_ += ms;
    if (++draws_ == kDraws || ms > kHopeless * allowed_ms() || spent_ms_ + ms > kMostSpent) finish_image();
}

double TierTrial::allowed_ms() const {
    return kDrawingShare * target_ms_;
}

void TierTrial::finish_image() {
    if (least_ms_ > allowed_ms()) {
        result_ = image_ == 0 ? Tier::kFast : kTrials[image_ - 1].tier;
    } else if (image_ + 1 == kTrials.size() || least_ms_ * kNextCosts > allowed_ms() ||
               spent_ms_ + least_ms_ * kTrials[image_ + 1].samples / kTrials[image_].samples > kMostSpent) {
        result_ = kTrials[image_].tier;
    } else {
        ++image_;
        draws_ = 0;
    }
}

}  // namespace game
