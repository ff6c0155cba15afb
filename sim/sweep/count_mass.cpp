#include "sim/sweep/count_mass.h"

#include <algorithm>

#include "sim/sweep/sweep.h"
#include "sim/world/state.h"

namespace sim {
namespace {

// Returns the sum of a layer on vertices x0 … x1-1 by y0 … y1-1.
std::int64_t quanta_in(const Field<float>& layer, InstructionSet set, int x0, int x1, int y0, int y1) {
    return sweep::kernels_for(set).quanta(layer.row(y0) + x0, layer.stride(), x1 - x0, y1 - y0);
}
std::int64_t quanta_in(const Field<float>& layer, InstructionSet set) {
    return quanta_in(layer, set, 0, layer.nx(), 0, layer.ny());
}

void count_mixture(Mixture& m, InstructionSet set) {
    m.ledger.standing = quanta_in(m.settled, set) + quanta_in(m.untouched, set);
    m.ledger.rolling = quanta_in(m.rolling, set);
}

}  // namespace

void count_mass(State& s) {
    const InstructionSet set = best_instruction_set();
    s.ledger.standing = quanta_in(s.depth, set);
    s.ledger.rolling = quanta_in(s.rolling, set);
    if (s.mixture) count_mixture(*s.mixture, set);
}

void count_changed_mass(State& s, InstructionSet set) {
    Tiles& tiles = s.tiles;
    s.ledger.standing = s.ledger.rolling = 0;
    for (int row = 0; row < tiles.rows; ++row)
        for (int column = 0; column < tiles.columns; ++column) {
            const std::size_t tile = tiles.number(column, row);
            Tiles::Mass& mass = tiles.mass[tile];
            if (tiles.uncounted[tile]) {
                const int x0 = column * tiles.width, x1 = std::min(x0 + tiles.width, s.grid.nx);
                const int y0 = row * tiles.height, y1 = std::min(y0 + tiles.height, s.grid.ny);
                mass = {quanta_in(s.depth, set, x0, x1, y0, y1), quanta_in(s.rolling, set, x0, x1, y0, y1)};
                tiles.uncounted[tile] = 0;
            }
            s.ledger.standing += mass.standing;
            s.ledger.rolling += mass.rolling;
        }
    if (s.mixture) count_mixture(*s.mixture, set);
}

}  // namespace sim
