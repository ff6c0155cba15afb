#include "game/session/try_watch.h"

#include <algorithm>
#include <cmath>

namespace game {

TryWatch::TryWatch(const Goal& goal, float tick_s) {
    const auto ticks = [&](double seconds) { return std::llrint(seconds / static_cast<double>(tick_s)); };
    earliest_ = ticks(goal.earliest_s);
    if (!goal.events.empty()) earliest_ = std::max(earliest_, goal.events.back().tick + 1);
    calm_enough_ = ticks(kCalm);
    if (goal.latest_s) latest_ = ticks(*goal.latest_s);
}

void TryWatch::see(const sim::State& state) {
    if (ended_at_) return;
    most_moved_ = std::max(most_moved_, state.ledger.rolling);
    const bool calm = most_moved_ > 0 && state.ledger.rolling * kStillMoves < most_moved_;
    calm_ = calm && state.tick >= earliest_ ? calm_ + 1 : 0;
    if (calm_ >= calm_enough_ || (latest_ && state.tick >= *latest_)) ended_at_ = state.tick;
}

}  // namespace game
