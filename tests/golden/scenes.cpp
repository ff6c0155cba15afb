#include "tests/golden/scenes.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace golden {
namespace {

using sim::Border;
using support::Ground;

// Pseudo-random values with some six digits, 0 ≤ n < 1.
double noise(int x, int y) {
    auto n = static_cast<std::uint32_t>(x) * 374761393u + static_cast<std::uint32_t>(y) * 668265263u;
    n = (n ^ (n >> 13)) * 1274126177u;
    return static_cast<double>((n ^ (n >> 16)) % 1000003u) / 1000003.0;
}

sim::Params numbers() {
    sim::Params params = support::lively(sim::Model::kBcre);
    params.rolling_speed = 8;
    params.speed_per_slope = 15;
    params.shear_rate = 6;
    return params;
}

double distance(double x, double y) {
    return std::sqrt(x * x + y * y);
}

// A cone of sand, steeper than is stable, on a table with edges to fall over; more is added beside it.
Scene pile_on_a_table() {
    Ground ground({50, 47, 1});
    ground.set(ground.depth,
               [](double x, double y) { return std::max(0., 9 - 0.8 * distance(x - 24, y - 23)); });
    sim::Params params = numbers();
    params.borders.fill(Border::kSink);
    return {"a pile on a table", ground, params, {{20, support::pour_at(31, 12, 3, 25, 1.0)}}};
}

// A channel down a slope, with cover in it.
Scene gully() {
    Ground ground({45, 58, 4});
    ground.set(ground.bedrock, [](double x, double y) {
        const double across = (x - 90) / 30;
        return -0.62 * y - 22 / (1 + across * across) + 2 * noise(static_cast<int>(x), static_cast<int>(y));
    });
    ground.set(ground.depth, [](double, double y) { return y > 60 ? 0.8 : 0.2; });
    sim::Params params = numbers();
    params.borders[sim::kSouth] = Border::kWall;
    return {"a gully", ground, params, {{1, support::pour_at(92, 20, 16, 900, 0.8)}}};
}

// A wall of bedrock across a slope, with a gap; the flow is held and passes through it.
Scene dam() {
    Ground ground({61, 44, 2});
    ground.set(ground.bedrock, [](double x, double y) {
        const double wall = std::max(0., 8 - 3 * std::fabs(y - 50));
        return -0.66 * y + (std::fabs(x - 66) < 7 ? 0 : wall);
    });
    ground.set(ground.depth, [](double, double y) { return y < 46 ? 0.5 : 0.1; });
    ground.set(ground.rolling,
               [](double x, double y) { return std::max(0., 2.5 - 0.2 * distance(x - 60, y - 18)); });
    sim::Params params = numbers();
    params.borders[sim::kWest] = params.borders[sim::kEast] = Border::kWall;
    sim::Command blast = support::pour_at(40, 14, 6, 0, 0);
    blast.kind = sim::CommandKind::kBlast;
    blast.depth = 0.4;
    return {"a dam", ground, params, {{40, blast}}};
}

// A hill of equal steepness on all sides, under snow.
Scene hill() {
    Ground ground({66, 66, 5});
    ground.set(ground.bedrock, [](double x, double y) { return -0.68 * distance(x - 140, y - 170); });
    ground.set(ground.depth, [](double, double) { return 0.6; });
    sim::Command dig = support::pour_at(170, 150, 12, 0.5, 0.5);
    dig.kind = sim::CommandKind::kDig;
    return {"a hill", ground, numbers(), {{1, support::pour_at(150, 190, 20, 2500, 0.5)}, {60, dig}}};
}

// Rough ground with a hole in the data, thick flow, and other borders on every side.
Scene rough_ground() {
    Ground ground({71, 40, 3});
    ground.set(ground.bedrock, [](double x, double y) {
        return -0.5 * x + 0.2 * y + 2.5 * noise(static_cast<int>(x / 3), static_cast<int>(y / 3));
    });
    ground.set(ground.depth,
               [](double x, double y) { return noise(static_cast<int>(y), static_cast<int>(x)); });
    ground.set(ground.rolling, [](double x, double y) { return x < 60 && y > 30 ? 1.4 : 0; });
    for (int y = 14; y < 19; ++y)
        for (int x = 33; x < 41; ++x) ground.has_data[ground.at(x, y)] = 0;
    sim::Params params = numbers();
    params.law = sim::Law::kSlope;
    params.exchange_depth = 0.5f;
    params.levelling = 1;
    params.borders = {Border::kWall, Border::kOpen, Border::kSink, Border::kWall};
    return {"rough ground", ground, params, {{30, support::pour_at(20, 60, 9, 300, 0.4)}}};
}

// Light material over heavy; both are added.
Scene snow_on_soil() {
    Ground ground({48, 41, 4});
    ground.set(ground.bedrock, [](double x, double y) {
        return -0.66 * y - 0.1 * x + noise(static_cast<int>(x), static_cast<int>(y));
    });
    ground.set(ground.depth, [](double, double) { return 1.2; });
    ground.set(ground.lower_depth, [](double, double y) { return y < 100 ? 0.7 : 1.1; });
    ground.lower = numbers();
    ground.lower->exchange_rate = 0.7f;
    ground.lower->rolling_speed = 3;
    ground.lower->max_speed = 7;
    ground.lower->erosion_slope = 0.6f;
    ground.lower->start_slope = 0.8f;
    sim::Command lower = support::pour_at(60, 90, 14, 300, 0.5);
    lower.of = sim::Part::kLower;
    return {"snow on soil", ground, numbers(), {{1, support::pour_at(100, 24, 16, 900, 0.8)}, {40, lower}}};
}

// Soil under a shower and a drain, which lets go; forest holds some of it.
Scene rain() {
    Ground ground({64, 50, 3});
    ground.set(ground.bedrock, [](double x, double y) {
        return -0.6 * y - 0.05 * x + 0.3 * noise(static_cast<int>(x / 3), static_cast<int>(y / 3));
    });
    ground.set(ground.depth,
               [](double x, double y) { return 0.5 + noise(static_cast<int>(y), static_cast<int>(x)); });
    ground.density = 1900;
    ground.forest.resize(ground.grid.size());
    for (int y = 30; y < 40; ++y)
        for (int x = 20; x < 30; ++x) ground.forest[ground.at(x, y)] = {300, 0, 30, 22};
    sim::Command wet = support::pour_at(90, 70, 55, 0.1, 3), drain = support::pour_at(120, 90, 20, 0.03, 1);
    wet.kind = sim::CommandKind::kWet, wet.profile = sim::Profile::kCone;
    drain.kind = sim::CommandKind::kDrain;
    return {"rain", ground, numbers(), {{2, wet}, {100, drain}}};
}

}  // namespace

std::vector<Scene> scenes() {
    return {pile_on_a_table(), gully(), dam(), hill(), rough_ground(), snow_on_soil(), rain()};
}

}  // namespace golden
