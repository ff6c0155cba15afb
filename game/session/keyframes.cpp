#include "game/session/keyframes.h"

#include <algorithm>

#include "sim/core/check.h"

namespace game {
namespace {

bool is_after(std::int64_t tick, const Session::Checkpoint& moment) {
    return tick < moment.world.tick;
}

}  // namespace

Keyframes::Keyframes(std::size_t bytes, std::size_t bytes_each)
    : most_(std::max<std::size_t>(bytes / bytes_each, 2)) {
    moments_.reserve(most_);
}

void Keyframes::pass(const Session& session) {
    const std::int64_t tick = session.state().tick;
    // Ticks before the last keyframe were kept already, or were dropped on purpose.
    if (tick % spacing_ != 0 || (!moments_.empty() && moments_.back().world.tick >= tick)) return;
    while (moments_.size() == most_) {
        spacing_ *= 2;
        std::erase_if(moments_, [this](const auto& moment) { return moment.world.tick % spacing_ != 0; });
        if (tick % spacing_ != 0) return;
    }
    moments_.push_back(session.moment());
}

const Session::Checkpoint& Keyframes::before(std::int64_t tick) const {
    const auto after = std::upper_bound(moments_.begin(), moments_.end(), tick, is_after);
    CHECK(after != moments_.begin());
    return *(after - 1);
}

void Keyframes::forget_after(std::int64_t tick) {
    moments_.erase(std::upper_bound(moments_.begin(), moments_.end(), tick, is_after), moments_.end());
}

}  // namespace game
