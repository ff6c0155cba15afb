#include "game/controls/pace.h"

#include <algorithm>

namespace game {

void Pace::see(const sim::State& state, double now_s) {
    constexpr double kRelease = 500;  // m³ that begin to move at once; a hand pours less
    const std::int64_t moves = state.ledger.rolling;
    const double quantum = static_cast<double>(sim::kQuantum) * state.grid.cell_area();
    if (static_cast<double>(moves - moved_) * quantum >= kRelease && moves >= 2 * moved_)
        slow_until_ = now_s + kSlowFor;
    moved_ = moves;
    most_moved_ = moves == 0 ? 0 : std::max(most_moved_, moves);
    // What pours or breaks loose now will move.
    creeps_ = moves > 0 && moves * kStillCreeps < most_moved_ && state.running_commands.empty();
}

}  // namespace game
