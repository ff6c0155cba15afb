#include "sim/world/state.h"

namespace sim {

bool at_rest(const State& state) {
    return state.ledger.rolling == 0 && state.running_commands.empty();
}

}  // namespace sim
