#include "sim/world/state.h"

#include <algorithm>

namespace sim {
namespace {

bool has_velocity(const State& state) {
    const auto moves = [](float speed) { return speed != 0; };
    for (int y = 0; y < state.grid.ny; ++y)
        for (const Field<float>* velocity : {&state.velocity_x, &state.velocity_y})
            if (std::any_of(velocity->row(y), velocity->row(y) + state.grid.nx, moves)) return true;
    return false;
}

}  // namespace

bool at_rest(const State& state) {
    const bool stands = state.ledger.rolling == 0 || state.still_ticks == 2;
    return stands && state.running_commands.empty() && (!state.weather || state.weather->is_over());
}

bool is_calm(const State& state) {
    return state.weather && !state.weather->is_over() && state.ledger.rolling == 0 &&
           state.running_commands.empty();
}

void count_still_ticks(State& state) {
    if (state.params.model != Model::kVoellmy) return;
    state.still_ticks = has_velocity(state) ? 0 : std::min(state.still_ticks + 1, 2);
}

}  // namespace sim
