#include "sim/ledger.h"

#include "sim/state.h"

namespace sim {
namespace {

std::int64_t quanta_in(const Field<float>& field) {
    std::int64_t sum = 0;
    for (int y = 0; y < field.ny(); ++y) {
        const float* row = field.row(y);
        for (int x = 0; x < field.nx(); ++x) sum += static_cast<std::int32_t>(row[x] / kQuantum);
    }
    return sum;
}

}  // namespace

void count_mass(State& state) {
    state.ledger.standing = quanta_in(state.depth);
    state.ledger.rolling = quanta_in(state.rolling);
}

}  // namespace sim
