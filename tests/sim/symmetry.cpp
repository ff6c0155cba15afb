#include <gtest/gtest.h>

#include "tests/support/worlds.h"

// A turned or mirrored world evolves as the turned or mirrored original, bit-identical: the order of
// operations favours no direction of the grid.

namespace {

using support::Ground;
using support::Play;

// The source of vertex (x, y) in a square world.
using Turn = std::pair<int, int> (*)(int x, int y, int last);

Ground turned(const Ground& ground, Turn turn) {
    Ground other(ground.grid);
    const int last = ground.grid.nx - 1;
    for (int y = 0; y <= last; ++y)
        for (int x = 0; x <= last; ++x) {
            const auto [fx, fy] = turn(x, y, last);
            other.bedrock[other.at(x, y)] = ground.bedrock[ground.at(fx, fy)];
            other.depth[other.at(x, y)] = ground.depth[ground.at(fx, fy)];
            other.rolling[other.at(x, y)] = ground.rolling[ground.at(fx, fy)];
        }
    return other;
}

Ground square_rough(unsigned seed) {
    const Ground rough = support::rough(30, 2, seed);
    Ground square({31, 31, 2});
    for (int y = 0; y < 31; ++y)
        for (int x = 0; x < 31; ++x) {
            square.bedrock[square.at(x, y)] = rough.bedrock[rough.at(x, y)];
            square.depth[square.at(x, y)] = rough.depth[rough.at(x, y)];
            square.rolling[square.at(x, y)] = rough.rolling[rough.at(x, y)];
        }
    return square;
}

TEST(Symmetry, mirrored_transposed_and_turned_worlds_evolve_bit_identically) {
    const std::pair<const char*, Turn> turns[] = {
        {"mirrored", [](int x, int y, int last) { return std::pair(last - x, y); }},
        {"transposed", [](int x, int y, int) { return std::pair(y, x); }},
        {"quarter turn", [](int x, int y, int last) { return std::pair(y, last - x); }},
    };
    for (const auto model : sim::kEveryModel)
        for (const auto scheme :
             {sim::Scheme::kLaxFriedrichs, sim::Scheme::kLocalLaxFriedrichs, sim::Scheme::kMuscl})
            for (const auto& [name, turn] : turns) {
                const Ground ground = square_rough(4);
                sim::Params params = support::lively(model, scheme);
                // Of the models with momentum, which have no scheme, these are others of their terms.
                if (scheme == sim::Scheme::kMuscl)
                    params.drag_exponent = 0.375f, params.fluidization = 0.222f,
                    params.cohesion_depth = 0.04f;
                if (scheme == sim::Scheme::kLaxFriedrichs) params.levelling = 1;
                Play straight(ground, params);
                Play other(turned(ground, turn), params);
                straight.ticks(150);
                other.ticks(150);
                ASSERT_GT(straight.state.ledger.rolling, 0);
                for (int y = 0; y < 31; ++y)
                    for (int x = 0; x < 31; ++x) {
                        const auto [fx, fy] = turn(x, y, 30);
                        ASSERT_EQ(other.state.depth(x, y), straight.state.depth(fx, fy))
                            << name << " " << x << " " << y;
                        ASSERT_EQ(other.state.rolling(x, y), straight.state.rolling(fx, fy))
                            << name << " " << x << " " << y;
                    }
            }
}

}  // namespace
