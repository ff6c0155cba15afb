#include "sim/world/edit_layers.h"

#include <algorithm>

#include "sim/world/mixture.h"
#include "sim/world/quanta.h"

namespace sim {
namespace {

// Momentum stays: what is added is at rest, what is taken carries its share away.
void set_rolling(State& s, int x, int y, float rolling) {
    const float before = s.rolling(x, y);
    if (rolling > before) {
        s.velocity_x(x, y) *= before / rolling;
        s.velocity_y(x, y) *= before / rolling;
    } else if (rolling == 0) {
        s.velocity_x(x, y) = s.velocity_y(x, y) = 0;
    }
    s.rolling(x, y) = rolling;
}

}  // namespace

float room_in(float layer) {
    return std::max(kDeepest / 2 - layer, 0.f);
}

// In each the mixture goes first, because it needs the layers as they were.

void pour_at(State& s, int x, int y, Layer layer, Part of, float amount) {
    if (of == Part::kLower) pour_lower(s, x, y, layer == Layer::kRolling, amount);
    if (layer == Layer::kStanding)
        s.depth(x, y) += amount;
    else
        set_rolling(s, x, y, s.rolling(x, y) + amount);
    s.ledger.poured += static_cast<std::int64_t>(amount / kQuantum);
}

void dig_at(State& s, int x, int y, float from_rolling, float from_standing) {
    dig_mixture(s, x, y, from_rolling, from_standing);
    set_rolling(s, x, y, s.rolling(x, y) - from_rolling);
    s.depth(x, y) -= from_standing;
    s.ledger.dug += static_cast<std::int64_t>(from_rolling / kQuantum) +
                    static_cast<std::int64_t>(from_standing / kQuantum);
}

void start_at(State& s, int x, int y, float amount) {
    start_mixture(s, x, y, amount);
    s.depth(x, y) -= amount;
    set_rolling(s, x, y, s.rolling(x, y) + amount);
}

void settle_at(State& s, int x, int y, float amount) {
    stop_mixture(s, x, y, amount);
    s.depth(x, y) += amount;
    set_rolling(s, x, y, s.rolling(x, y) - amount);
    // With weather d₀ tells what moved until the next anchor (sim/weather/anchor.h).
    if (!s.weather) s.first_depth(x, y) = std::max(s.first_depth(x, y), s.depth(x, y));
}

}  // namespace sim
