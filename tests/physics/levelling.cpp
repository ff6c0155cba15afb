#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "tests/support/worlds.h"

// What levelling at the faces (sim/momentum/transport.h) does to deposits, and what it must not do to rest.

namespace {

using sim::Model;
using support::Ground;
using support::Play;

// A channel of 34° that eases onto level ground, with a heap of 40,000 m³ at its head.
Ground channel(float dx) {
    Ground ground({static_cast<int>(400 / dx) + 1, static_cast<int>(1200 / dx) + 1, dx});
    ground.set(ground.bedrock, [](double x, double y) {
        const double up = y - 500, ease = 150, steep = 0.67 * (up + std::sqrt(up * up + ease * ease)) / 2;
        return steep + 0.0008 * std::min(steep / 100, 1.) * (x - 200) * (x - 200);
    });
    ground.set(ground.rolling,
               [](double x, double y) { return std::max(0., 6 * (1 - std::hypot(x - 200, y - 1050) / 80)); });
    return ground;
}

// The checkerboard of a deposit, root mean square over vertices with more than 0.3 m, m; the bed is smooth.
double checkerboard(const sim::State& s) {
    const auto lies = [&](int x, int y) { return static_cast<double>(s.depth(x, y) + s.rolling(x, y)); };
    double sum = 0;
    int count = 0;
    for (int y = 1; y + 1 < s.grid.ny; ++y)
        for (int x = 1; x + 1 < s.grid.nx; ++x) {
            if (lies(x, y) < 0.3) continue;
            const double beside = lies(x - 1, y) + lies(x + 1, y) + lies(x, y - 1) + lies(x, y + 1);
            const double across =
                lies(x - 1, y - 1) + lies(x + 1, y - 1) + lies(x - 1, y + 1) + lies(x + 1, y + 1);
            const double board = lies(x, y) - beside / 2 + across / 4;
            sum += board * board, ++count;
        }
    return std::sqrt(sum / count);
}

// Without levelling it is .13 and .11 m.
TEST(Levelling, leaves_little_checkerboard_in_a_deposit) {
    for (const auto model : {Model::kVoellmy, Model::kBcreInertial}) {
        sim::Params params = support::loose_dry_snow();
        params.model = model;
        params.friction = 0.4f;
        params.levelling = 1;
        Play play(channel(10), params);
        play.until_rest(120);
        const double rms = checkerboard(play.state);
        EXPECT_LT(rms, 0.08) << sim::to_string(model);
        EXPECT_EQ(play.state.ledger.mass_error(), 0);
    }
}

// Steps of many metres, as in a gully on coarse cells. Layers at their foot, and in ponds of two cells between them, flowed
// for ever, by the walls alone: on 7 and 11 before there was levelling, on 3 and 4 with levelling as first tried.
TEST(Levelling, lets_a_layer_rest_among_steep_walls) {
    for (const unsigned seed : {3, 4, 7, 11}) {
        Ground ground = support::rough(48, 10, seed);
        sim::Params params = support::loose_dry_snow();
        params.friction = 0.25f;
        params.levelling = 1;
        params.drag = 500;
        for (float& rolling : ground.rolling) rolling *= 10;
        Play play(ground, params);
        play.until_rest(600);
        EXPECT_TRUE(sim::at_rest(play.state)) << seed;
    }
}

}  // namespace
