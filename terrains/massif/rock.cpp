#include "terrains/massif/mountain.h"

#include <algorithm>
#include <cmath>

namespace terrains::massif {

double Mountain::hardness(const Level& g, std::size_t a, double height) const {
    const Bed bed = bed_at(g, a, height);
    const double in = eased(0, 0.06, bed.t) * eased(bed.thick + 0.06, bed.thick, bed.t);
    return 0.5 + r_.hardness_contrast * (mixed(0.15, 0.5 + 0.5 * bed.strength, in) - 0.5);
}

Values Mountain::snow(const Level& g) const {
    const int reach = std::max(1, static_cast<int>(std::floor(0.5 + 0.007 * g.squares)));
    const Values mean = blurred(g, blurred(g, g.height, reach), reach);
    const double full = tangent(r_.bare - 10), bare = tangent(r_.bare);
    Values depth(g.size);
    for (std::size_t a = 0; a < g.size; ++a) {
        const double above = std::clamp((g.height[a] - r_.snow_line) / r_.snow_full, 0.0, 1.0);
        const double hollow = std::clamp((mean[a] - g.height[a]) / (0.0018 * r_.length), -1.0, 1.0);
        const double holds = std::clamp((bare - slope(g, g.height, a)) / (bare - full), 0.0, 1.0);
        depth[a] = r_.snow * above * holds * (hollow < 0 ? 1 + 0.95 * hollow : 1 + 0.6 * hollow);
    }
    return depth;
}

Mountain::Bed Mountain::bed_at(const Level& g, std::size_t a, double height) const {
    const double bed = (height + g.beds[a]) / r_.bed_thickness, index = std::floor(bed);
    const auto k = static_cast<std::int64_t>(index);
    return {bed - index, 0.3 + 0.3 * beds_.unit(k, 1), beds_.unit(k, 2)};
}

void Mountain::lay_out(Level& g) const {
    for (auto* field : {&g.height, &g.talus, &g.beds, &g.uplift, &g.weakness, &g.sound, &g.base})
        field->assign(g.size, 0);
    lay_out_uplift(g);
    lay_out_rock(g);
}

void Mountain::lay_out_uplift(Level& g) const {
    const Noise rise(seed_, 12), border(seed_, 13);
    for_places(g, [&](std::size_t a, double x, double y, const Plan::Crossing&) {
        const double axis = plan_.axis(x), north = y - axis - plan_.half_floor();
        const double south = axis - plan_.half_floor() - y;
        const double side =
            eased(0, 0.1, north) * (0.5 + 0.5 * eased(0, 0.45, north)) + 0.5 * eased(0, 0.1, south);
        const double shoulder = eased(0.06, 0.13, north) * eased(0.3, 0.18, north);
        const double spurs =
            0.9 * rise.octaves(4.3 * x, 1.1 * y + 30, 2) + 0.4 * rise.octaves(3.3 * x, 3.3 * y, 3);
        g.uplift[a] = side * (1 - 0.6 * r_.ice * shoulder) * std::clamp(1 + 1.5 * spurs, 0.2, 2.2);
        g.base[a] = kNotBase;
        if (y == 1) g.base[a] = r_.lowest + r_.relief * (0.45 + 0.2 * border.octaves(4 * x, 0.5, 2));
        if (std::abs(y - axis) <= std::max(0.3 * plan_.half_floor(), 0.6 / g.squares))
            g.base[a] = floor_height(x);
    });
}

void Mountain::lay_out_rock(Level& g) const {
    const Noise fold(seed_, 10), rock(seed_, 11), fault(seed_, 16), firm(seed_, 17);
    const double folded = std::min(0.03 * r_.length, 1.2 * r_.bed_thickness);
    const double width = std::max(0.006, 0.7 / g.squares), weak = g.squares < kDrawn ? 0.5 : 2.0;
    for_places(g, [&](std::size_t a, double x, double y, const Plan::Crossing& couloir) {
        const double s = couloir.s, away = couloir.away(x), wall = plan_.wall(couloir, x);
        g.beds[a] = r_.length * (dip_x_ * x + dip_y_ * y) + folded * fold.octaves(4 * x, 4 * y, 3);
        g.sound[a] = std::max(std::clamp(0.1 + 0.9 * firm.octaves(5 * x, 5 * y, 3), 0.0, 1.0) *
                                  eased(0.05, 0.2, y - plan_.north_edge(x)),
                              wall * eased(0.015 + 0.03 * wall, 0.01 + 0.018 * wall, away) *
                                  eased(0.02, 0.2, s) * eased(1, 0.85, s));
        const double joints = eased(0.16, 0, std::abs(fault.octaves(4.5 * x, 4.5 * y, 3)));
        const double flank = eased(0.05, 0.03, away) * eased(0, 0.1, s) * eased(1.05, 0.95, s);
        const double in = eased(2 * width, 0.5 * width, away) * eased(-0.05, 0, s) * eased(1.02, 0.95, s);
        const double patches = std::max(0.25, 0.8 + 0.8 * rock.octaves(9 * x, 9 * y, 4));
        g.weakness[a] = (patches + 1.3 * joints) * mixed(1, 0.6, flank) + weak * in;
    });
}

void Mountain::inherit_layout(const Level& g, Level& fine) const {
    fine.height.assign(fine.size, 0);
    fine.base.assign(fine.size, kNotBase);
    for (auto* field : {&fine.talus, &fine.beds, &fine.uplift, &fine.weakness, &fine.sound})
        field->resize(fine.size);
    std::vector<double> axis(fine.side);
    for (int i = 0; i < fine.side; ++i) axis[i] = plan_.axis(static_cast<double>(i) / fine.squares);
    for (int j = 0; j < fine.side; ++j)
        for (int i = 0; i < fine.side; ++i) {
            const std::size_t a = std::size_t(j) * fine.side + i;
            fine.beds[a] = sampled(g.beds, g.side, 0.5 * i, 0.5 * j);
            fine.uplift[a] = sampled(g.uplift, g.side, 0.5 * i, 0.5 * j);
            fine.sound[a] = sampled(g.sound, g.side, 0.5 * i, 0.5 * j);
            fine.weakness[a] = sampled(g.weakness, g.side, 0.5 * i, 0.5 * j);
            const bool river =
                std::abs(static_cast<double>(j) / fine.squares - axis[i]) <= 0.3 * plan_.half_floor();
            if (river) fine.base[a] = floor_height(static_cast<double>(i) / fine.squares);
            if (j == fine.squares) fine.base[a] = sampled(g.base, g.side, 0.5 * i, g.squares);
        }
}

void Mountain::weather(Level& g) const {
    const Noise crag(seed_, 30), lens(seed_, 31);
    const int reach = std::max(1, static_cast<int>(std::floor(0.5 + 0.005 * g.squares)));
    const Values mean = blurred(g, g.height, reach), wide = blurred(g, mean, 2 * reach), before = g.height;
    Values steepness(g.size);
    for (std::size_t a = 0; a < g.size; ++a) steepness[a] = slope(g, before, a);
    steepness = blurred(g, steepness, reach);  // not the slope of the mean, which is 0 on crests
    // Too coarse a grid does not show beds, and steep ones make no ledges.
    const double seen =
        eased(1.5, 5, r_.bed_thickness / g.dx) / (1 + 2 * (dip_x_ * dip_x_ + dip_y_ * dip_y_));
    for (std::size_t a = 0; a < g.size; ++a) {
        if (g.base[a] > kNotBase) continue;
        const double steep = steepness[a], bare = eased(1, 0, g.talus[a]);
        const std::size_t column = a % g.side, row = a / g.side;
        const double x = g.dx * static_cast<double>(column), y = g.dx * static_cast<double>(row);
        const double up = (before[a] - r_.lowest) / r_.relief;
        const double rock = eased(0.4, 0.65, steep) * bare * eased(0.03, 0.2, up);
        if (rock == 0) continue;
        const Bed bed = bed_at(g, a, before[a]);
        const double patch = lens.octaves(x / (5 * r_.bed_thickness), y / (5 * r_.bed_thickness), 2);
        const double rib = eased(0.004 * r_.length, -0.001 * r_.length, wide[a] - before[a]);
        const double bold = rib * std::clamp(1.2 * bed.strength - 0.25 + 0.6 * patch, 0.0, 0.8);
        const double from = bed.thick * (1 - r_.hardness_contrast * bold * eased(1.7, 0.9, steep));
        const double moved = bed.t < from ? bed.t * bed.thick / from
                                          : bed.thick + (bed.t - from) * (1 - bed.thick) / (1 - from);
        g.height[a] += seen * rock * r_.bed_thickness * (moved - bed.t);
        double amplitude = r_.roughness;
        for (double wave = 64; wave > 5 && wave > 3 * g.dx; wave *= 0.5, amplitude *= 0.55)
            g.height[a] += rock * amplitude * (0.35 - std::abs(crag.at(x / wave + 0.37 * wave, y / wave)));
    }
}

double Mountain::steepest(const Level& g, int a, double hard) const {
    const double up = std::clamp((g.height[a] - r_.lowest) / r_.relief, 0.0, 1.0);
    const double sound = 0.02 + 0.2 * up * up + 0.65 * g.sound[a] - 0.12 * (g.weakness[a] - 1) +
                         0.15 * r_.hardness_contrast * (hard - 0.5);
    return mixed(soft_, hard_, std::clamp(sound, 0.0, 1.0));
}

}  // namespace terrains::massif
