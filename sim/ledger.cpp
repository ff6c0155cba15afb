#include "sim/ledger.h"

#include <algorithm>

#include "sim/state.h"

namespace sim {
namespace {

// A row of layers in quanta. Each is at most 2²⁴, so that many fit in 32 bits, in which they are added
// faster.
std::int64_t quanta_in_row(const float* row, int count) {
    constexpr int kTogether = 64;
    std::int64_t sum = 0;
    for (int from = 0; from < count; from += kTogether) {
        std::int32_t part = 0;
        for (int x = from; x < std::min(from + kTogether, count); ++x)
            part += static_cast<std::int32_t>(row[x] * (1 / kQuantum));
        sum += part;
    }
    return sum;
}

std::int64_t quanta_in(const Field<float>& field) {
    std::int64_t sum = 0;
    for (int y = 0; y < field.ny(); ++y) sum += quanta_in_row(field.row(y), field.nx());
    return sum;
}

}  // namespace

void count_mass(State& state) {
    state.ledger.standing = quanta_in(state.depth);
    state.ledger.rolling = quanta_in(state.rolling);
}

}  // namespace sim
