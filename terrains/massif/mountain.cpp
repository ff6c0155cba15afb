#include "terrains/massif/mountain.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace terrains::massif {

Mountain::Mountain(const Massif& recipe, std::uint64_t seed)
    : r_(recipe),
      plan_(recipe.valley / recipe.length, seed),
      seed_(seed),
      soft_(tangent(recipe.soft_slope)),
      hard_(std::max(soft_, tangent(recipe.hard_slope))),
      lift_(recipe.relief * kErosion / 5) {
    const sim::Direction falls = sim::direction_of(r_.bed_direction);
    dip_x_ = tangent(r_.bed_dip) * falls.x;
    dip_y_ = tangent(r_.bed_dip) * falls.y;
}

Level Mountain::make(int squares) {
    Level g(kCoarsest, r_.length);
    lay_out(g);
    start(g);
    for (int k = 0; k < 110; ++k) {
        step(g, 1, false);
        steer(g);
    }
    stretch(g);
    while (g.squares < std::max(squares, std::min(2 * squares, kDrawn)) && g.squares < kFinest) refine(g);
    if (g.squares == kCoarsest) finish_valley(g);
    const Level unbent = g;
    bend(unbent, g);
    carve_couloir(g);
    build_fan(g);
    flood(g);
    g.height = g.filled;
    weather(g);
    flood(g);
    g.height = g.filled;
    route(g, Noise(seed_, 100));
    return g;
}

void Mountain::steer(const Level& g) {
    const double reached = std::max(1e-3, (highest(g) - r_.lowest) / r_.relief);
    lift_ = std::clamp(lift_ * std::clamp(1 + 0.1 * (1 / reached - 1), 0.9, 1.1), 1e-3 * r_.relief,
                       0.3 * r_.relief);
}

void Mountain::stretch(Level& g) const {
    const double factor = std::clamp(r_.relief / std::max(1e-3, highest(g) - r_.lowest), 0.05, 1.2);
    for (double& height : g.height) height = r_.lowest + factor * (height - r_.lowest);
}

void Mountain::bend(const Level& from, Level& to) const {
    const Noise east(seed_, 200 + to.squares + from.squares), north(seed_, 300 + to.squares + from.squares);
    const double ratio = static_cast<double>(from.squares) / to.squares;
    for (int j = 0; j < to.side; ++j) {
        const auto couloir = plan_.crossing(static_cast<double>(j) / to.squares);
        for (int i = 0; i < to.side; ++i) {
            const double x = ratio * i, y = ratio * j, away = couloir.away(x / from.squares);
            const double most = (to.squares <= kDrawn ? 1.5 : 1.0) * eased(0.02, 0.06, away);
            const double bx = x + most * east.octaves(0.11 * x, 0.11 * y, 2);
            const double by = y + most * north.octaves(0.11 * x, 0.11 * y, 2);
            const std::size_t a = std::size_t(j) * to.side + i;
            to.height[a] = smoothly_sampled(from.height, from.side, bx, by);
            to.talus[a] = std::max(0.0, sampled(from.talus, from.side, bx, by));
            if (to.base[a] > kNotBase) to.height[a] = to.base[a];
        }
    }
}

void Mountain::refine(Level& g) {
    Level fine(2 * g.squares, r_.length);
    if (fine.squares <= kDrawn)
        lay_out(fine);
    else
        inherit_layout(g, fine);
    bend(g, fine);
    g = std::move(fine);
    if (g.squares == 2 * kCoarsest) {
        for (int k = 0; k < 25; ++k) step(g, 0.8, false);
        finish_valley(g);
        for (int k = 0; k < 6; ++k) step(g, 0.2, true);
    } else {
        const int steps = g.squares == 256 ? 7 : g.squares == 512 ? 3 : 2;
        carve_couloir(g);
        for (int k = 0; k < steps; ++k) step(g, 0.2, true);
    }
}

double Mountain::floor_height(double x) const {
    return r_.lowest + 0.03 * r_.relief * plan_.floor_rise(x);
}

double Mountain::highest(const Level& g) const {
    return *std::max_element(g.height.begin(), g.height.end());
}

}  // namespace terrains::massif
