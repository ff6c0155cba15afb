#include "game/controls/pace.h"

#include <algorithm>
#include <utility>

#include "sim/weather/sky.h"

namespace game {
namespace {

std::ptrdiff_t struck_houses(const sim::State& state) {
    constexpr std::int64_t kStrikes = 1000;  // Pa; less breaks no window
    if (!state.things) return 0;
    return std::ranges::count_if(state.things->list, [](const sim::Thing& thing) {
        return thing.kind == sim::ThingKind::kHouse && thing.load >= kStrikes;
    });
}

}  // namespace

double shown_seconds(const sim::State& calm) {
    constexpr double kFair = 1.0 / 6, kStorm = 1.0 / 2;  // s
    return sim::weather::sky_of(*calm.weather).precipitation > 0 ? kStorm : kFair;
}

void Pace::see(const sim::State& state, double now_s) {
    constexpr double kRelease = 500;  // m³ that begin to move at once; a hand pours less
    const std::int64_t moves = state.ledger.rolling;
    const double quantum = static_cast<double>(sim::kQuantum) * state.grid.cell_area();
    if (static_cast<double>(moves - moved_) * quantum >= kRelease && moves >= 2 * moved_)
        slow_until_ = now_s + kSlowFor;
    const std::ptrdiff_t struck = struck_houses(state);
    if (struck_ >= 0 && struck > struck_ && !std::exchange(has_hit_, true)) slow_until_ = now_s + kSlowFor;
    has_hit_ &= moves > 0;
    struck_ = struck;
    moved_ = moves;
    most_moved_ = moves == 0 ? 0 : std::max(most_moved_, moves);
    // What pours or breaks loose now will move.
    creeps_ = moves > 0 && moves * kStillCreeps < most_moved_ && state.running_commands.empty();
}

}  // namespace game
