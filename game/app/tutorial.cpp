#include "game/app/tutorial.h"

#include <algorithm>
#include <iterator>
#include <utility>
#include <variant>

namespace game {
namespace {

constexpr double kOpeningLasts = 50, kLongestOpening = 30;  // s of the slide; s

}  // namespace

void Tutorial::begin(const Remembered& led, bool watches, double now_s) {
    guide_ = led.guide;
    kept_step_ = led.guide.step();
    if (guide_->step() != Guide::Step::kWatch) return;
    if (watches)
        opening_since_ = now_s;
    else
        guide_->next();
}

std::optional<double> Tutorial::opening_s(double now_s) const {
    return opening_since_ ? std::optional(now_s - *opening_since_) : std::nullopt;
}

bool Tutorial::opening_ends(std::span<const Event> events, double world_s, double now_s) const {
    const auto is_press = [](const Event& event) {
        const auto* const key = std::get_if<KeyEvent>(&event);
        const auto* const button = std::get_if<ButtonEvent>(&event);
        return (key && key->down) || (button && button->down);
    };
    return world_s >= kOpeningLasts || opening_s(now_s) >= kLongestOpening ||
           std::ranges::any_of(events, is_press);
}

void Tutorial::end_opening() {
    opening_since_.reset();
    guide_->next();
}

std::span<const Event> Tutorial::without_presses(std::span<const Event> events) {
    left_.clear();
    std::ranges::copy_if(events, std::back_inserter(left_), [](const Event& event) {
        return !std::holds_alternative<KeyEvent>(event) && !std::holds_alternative<ButtonEvent>(event) &&
               !std::holds_alternative<WheelEvent>(event) && !std::holds_alternative<TextEvent>(event);
    });
    return left_;
}

std::optional<Guide::Step> Tutorial::see(const Guide::Seen& seen) {
    if (!guide_) return std::nullopt;
    guide_->see(seen);
    if (std::exchange(kept_step_, guide_->step()) == guide_->step()) return std::nullopt;
    return kept_step_;
}

void Tutorial::did(sim::CommandKind kind) {
    if (guide_) guide_->did(kind);
}

void Tutorial::perform(const GuideWish& wish) {
    if (!guide_) return;
    if (wish.kind == GuideWish::kNext)
        guide_->next();
    else
        guide_.emplace(Guide::Step::kBlast);
}

}  // namespace game
