#include "terrains/massif/mountain.h"

#include <algorithm>
#include <cmath>

namespace terrains::massif {

void Mountain::finish_valley(Level& g) {
    carve_trough(g);
    carve_cirques(g);
    trace_couloir(g);
    carve_couloir(g);
    build_fan(g);
}

void Mountain::carve_trough(Level& g) const {
    const Noise shoulder(seed_, 20);
    for_places(g, [&](std::size_t a, double x, double y, const Plan::Crossing&) {
        if (g.base[a] > kNotBase) return;
        const double out = std::max(y - plan_.north_edge(x), plan_.axis(x) - plan_.half_floor() - y);
        const double tall = r_.relief * (0.26 + 0.12 * shoulder.at(5 * x, y < plan_.axis(x) ? 0.5 : 7.5));
        const double t = std::max(0.0, out * r_.length + 0.25 * tall) / (1.3 * tall);
        const double wall = floor_height(x) + tall * t * t;
        g.height[a] = mixed(g.height[a], std::min(g.height[a], wall), std::min(1.0, 1.5 * r_.ice));
    });
}

void Mountain::carve_cirques(Level& g) const {
    const Noise number(seed_, 21);
    for (int k = 0; k < 3; ++k) {
        const double radius = 0.075 + 0.035 * number.unit(k, 0), y = 0.66 + 0.09 * number.unit(k, 1);
        const double from = std::array<double, 3>{0.1, 0.7, 0.27}[k];
        double x = from, lowest = 1e9;
        for (int m = 0; m <= 20; ++m) {
            const double at = from + 0.01 * m;
            const double z = sampled(g.height, g.side, at * g.squares, y * g.squares);
            if (z < lowest) lowest = z, x = at;
        }
        for_places(g, [&](std::size_t a, double at_x, double at_y, const Plan::Crossing&) {
            if (g.base[a] > kNotBase) return;
            const double dx = at_x - x, dy = at_y - y;
            const double e = std::max(0.0, std::sqrt(dx * dx + dy * dy) / radius - 0.5);
            const double bowl =
                lowest + 0.15 * r_.length * std::max(dy, -0.5 * radius) + 1.3 * r_.relief * e * e;
            g.height[a] = mixed(g.height[a], std::min(g.height[a], bowl), r_.ice);
        });
    }
}

void Mountain::trace_couloir(const Level& g) {
    const Noise uneven(seed_, 22);
    double lowest_above = 1e9;
    for (int k = kTrace; k >= 0; --k) {
        const double s = static_cast<double>(k) / kTrace;
        const double depth = (0.06 + 0.02 * uneven.at(6 * s, 9.5)) * eased(0, 0.3, s) * eased(1.05, 0.8, s);
        const double ground =
            sampled(g.height, g.side, plan_.couloir_at(s).x * g.squares, plan_.couloir_y(s) * g.squares);
        lowest_above = std::min(lowest_above, ground - r_.relief * depth);
        trace_[k] = lowest_above;
    }
    for (int pass = 0; pass < 8; ++pass)
        for (int k = 1; k < kTrace; ++k) trace_[k] = (trace_[k - 1] + 2 * trace_[k] + trace_[k + 1]) / 4;
}

void Mountain::carve_couloir(Level& g) const {
    const Noise uneven(seed_, 22);
    for_places(g, [&](std::size_t a, double x, double y, const Plan::Crossing& couloir) {
        const double s = couloir.s, away = couloir.away(x);
        if (s <= 0 || s >= 1 || away > 0.08 || g.base[a] > kNotBase) return;
        const int k = static_cast<int>(s * kTrace);
        const double below = std::max(0.0, 1 - 10 * s), above = std::max(0.0, 8 * s - 7);
        const double bed = mixed(trace_[k], trace_[k + 1], s * kTrace - k) +
                           away * std::min(0.15 * r_.length, 0.45 * r_.relief) +
                           r_.relief * (0.05 * below * below + 0.2 * above * above);
        const double width = (0.0088 + 0.003 * uneven.at(9 * s, 0.5)) * (1 + eased(0.7, 1, s));
        const double half = std::max(width, 0.4 / g.squares);
        const double wall = std::max(0.0, away - half - 0.006 * uneven.octaves(70 * x, 70 * y, 2));
        const double steep = mixed(0.9, 1.75, plan_.wall(couloir, x));
        g.height[a] = std::min(g.height[a], bed + steep * wall * r_.length);
        const double filled = eased(half, 0.6 * half, away) * eased(0.06, 0.2, s) * eased(0.95, 0.85, s);
        raise_with_debris(g, a, g.height[a] + (bed - g.height[a]) * filled);
        g.talus[a] = std::max(g.talus[a], 2 * filled);  // keeps the bed smooth
    });
}

void Mountain::build_fan(Level& g) const {
    const double mouth_x = plan_.couloir_at(0.03).x, mouth_y = plan_.couloir_y(0.03);
    const double apex = trace_[2] + 0.01 * r_.relief;
    for_places(g, [&](std::size_t a, double x, double y, const Plan::Crossing&) {
        const double dx = x - mouth_x, dy = y - mouth_y, away = std::sqrt(dx * dx + dy * dy);
        if (away > 0.25 || g.base[a] > kNotBase) return;
        const double cone = apex - r_.length * (0.27 * away + std::max(0.0, dy));
        const double bank = std::max(0.0, y - plan_.axis(x) - 0.3 * plan_.half_floor());
        raise_with_debris(g, a, std::min(cone, floor_height(x) + 0.3 * bank * r_.length));
    });
}

void Mountain::raise_with_debris(Level& g, std::size_t a, double height) {
    g.talus[a] += std::max(0.0, height - g.height[a]);
    g.height[a] = std::max(g.height[a], height);
}

}  // namespace terrains::massif
