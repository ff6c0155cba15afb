#include "terrains/massif/mountain.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace terrains::massif {

void Mountain::start(Level& g) const {
    const Noise uneven(seed_, 14);
    for_places(g, [&](std::size_t a, double x, double y, const Plan::Crossing& couloir) {
        const double axis = plan_.axis(x), edge = axis + plan_.half_floor(), crest = plan_.crest(x);
        double up = std::clamp((y - edge) / (crest - edge), 0.0, 1.0);
        if (y > crest) up = mixed(1, 0.6, (y - crest) / (1 - crest));
        const double side = 0.72 * up + 0.72 * std::max(0.0, axis - plan_.half_floor() - y);
        const double cut = couloir.s > 0 && couloir.s < 1 ? 0.024 * eased(0.03, 0, couloir.away(x)) * up : 0;
        const double bumps = 0.1 * std::min(1.0, 4.4 * side) * uneven.octaves(8 * x, 8 * y, 4);
        g.height[a] = g.base[a] > kNotBase ? g.base[a] : floor_height(x) + r_.relief * (side - cut + bumps);
    });
}

void Mountain::step(Level& g, double time, bool with_debris) {
    flood(g);
    route(g, Noise(seed_, 1000 + steps_++));
    erode(g, time);
    if (with_debris) drop_debris(g, time);
    creep(g, time);
}

double Mountain::carrying_slope(double drainage) const {
    return 0.72 / (1 + std::sqrt(drainage / (0.008 * r_.length * r_.length)));
}

void Mountain::erode(Level& g, double time) {
    const double scale = r_.length * r_.length;
    for (const int a : g.order) {
        if (g.base[a] > kNotBase) {
            g.height[a] = g.base[a];
            continue;
        }
        const double hard = hardness(g, a, g.height[a]), away = g.distance[a];
        const double below = g.height[g.receiver[a]], raised = g.height[a] + lift_ * time * g.uplift[a];
        const double smooth =
            mixed(1.5e-3, 1.5e-4, eased(0.25, 0.7, (g.filled[a] - g.filled[g.receiver[a]]) / away));
        const double area =
            g.drainage[a] / (1 + smooth * scale / g.drainage[a] + g.drainage[a] / (kSteep * scale));
        const double speed = kErosion * time * g.weakness[a] * (1.5 - hard) * std::sqrt(area) / away;
        const double stop =
            g.talus[a] > 0 ? std::min(raised, below + carrying_slope(g.drainage[a]) * away) : below;
        double height = raised > stop ? (raised + speed * stop) / (1 + speed) : raised;
        height = std::min(height, below + steepest(g, a, hard) * away);
        g.talus[a] = std::max(0.0, g.talus[a] - std::max(0.0, raised - height));
        g.height[a] = height;
    }
}

void Mountain::drop_debris(Level& g, double time) {
    Values load(g.size, 0);
    for (auto k = g.order.rbegin(); k != g.order.rend(); ++k) {
        const int a = *k, b = g.receiver[a];
        if (a == b) continue;
        const double slope = (g.height[a] - g.height[b]) / g.distance[a];
        load[a] += time * 0.012 * r_.relief * eased(0.75, 1.3, slope);
        const double room = g.height[b] + carrying_slope(g.drainage[a]) * g.distance[a] - g.height[a];
        const double stays = std::clamp(0.6 * room, 0.0, load[a]);
        g.height[a] += stays;
        g.talus[a] += stays;
        load[b] += load[a] - stays;
    }
}

void Mountain::creep(Level& g, double time) {
    const double reach = 0.004 * r_.length / g.dx, wish = time * reach * reach;
    const int passes = std::clamp(static_cast<int>(wish / 0.2) + 1, 1, 4);
    const double strength = std::min(0.2, wish / passes);
    for (int pass = 0; pass < passes; ++pass) {
        Values next = g.height;
        for (int j = 1; j < g.squares; ++j)
            for (int i = 1; i < g.squares; ++i) {
                const std::size_t a = std::size_t(j) * g.side + i;
                if (g.base[a] > kNotBase) continue;
                const double* h = g.height.data() + a;
                const double gx = (h[1] - h[-1]) / (2 * g.dx), gy = (h[g.side] - h[-g.side]) / (2 * g.dx);
                const double loose =
                    std::max(eased(0.65, 0.4, std::sqrt(gx * gx + gy * gy)), std::min(1.0, g.talus[a] / 4));
                next[a] +=
                    strength * mixed(0.1, 1, loose) * (h[1] + h[-1] + h[g.side] + h[-g.side] - 4 * h[0]);
            }
        g.height.swap(next);
    }
}

}  // namespace terrains::massif
