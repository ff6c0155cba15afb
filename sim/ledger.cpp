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

std::int64_t quanta_in(const Field<float>& field, int x0, int x1, int y0, int y1) {
    std::int64_t sum = 0;
    for (int y = y0; y < y1; ++y) sum += quanta_in_row(field.row(y) + x0, x1 - x0);
    return sum;
}

void count_mixture(Mixture& m) {
    const int nx = m.rolling.nx(), ny = m.rolling.ny();
    m.ledger.standing = quanta_in(m.settled, 0, nx, 0, ny) + quanta_in(m.untouched, 0, nx, 0, ny);
    m.ledger.rolling = quanta_in(m.rolling, 0, nx, 0, ny);
}

}  // namespace

void count_mass(State& s) {
    s.ledger.standing = quanta_in(s.depth, 0, s.grid.nx, 0, s.grid.ny);
    s.ledger.rolling = quanta_in(s.rolling, 0, s.grid.nx, 0, s.grid.ny);
    if (s.mixture) count_mixture(*s.mixture);
}

void count_changed_mass(State& s) {
    Tiles& tiles = s.tiles;
    s.ledger.standing = s.ledger.rolling = 0;
    for (int row = 0; row < tiles.rows; ++row)
        for (int column = 0; column < tiles.columns; ++column) {
            const std::size_t tile = tiles.number(column, row);
            Tiles::Mass& mass = tiles.mass[tile];
            if (tiles.changed[tile]) {
                const int x0 = column * tiles.width, x1 = std::min(x0 + tiles.width, s.grid.nx);
                const int y0 = row * tiles.height, y1 = std::min(y0 + tiles.height, s.grid.ny);
                mass = {quanta_in(s.depth, x0, x1, y0, y1), quanta_in(s.rolling, x0, x1, y0, y1)};
                tiles.changed[tile] = 0;
            }
            s.ledger.standing += mass.standing;
            s.ledger.rolling += mass.rolling;
        }
    if (s.mixture) count_mixture(*s.mixture);
}

}  // namespace sim
