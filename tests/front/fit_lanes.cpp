#include "sim/front/fit_lanes.h"

#include <gtest/gtest.h>

#include <cstring>
#include <random>
#include <vector>

// The kernels of a fit: results are correct, and bit-identical for every instruction set.

namespace {

using namespace sim::front::fit;  // NOLINT(google-build-using-namespace): the namespace under test

constexpr int kFlips = 37, kCrossings = 14;

// Runs all kernels on random flips and crossings and returns their results as one list of numbers.
std::vector<double> answers(const Kernels& kernels) {
    std::mt19937 random(5);
    std::uniform_real_distribution<double> place(-4, 4), age(0, 3);
    std::vector<double> all;
    all.reserve(2000);
    const auto list = [&](int count, const auto& number) {
        double* const begin = all.data() + all.size();
        for (int i = 0; i < filled_up(count); ++i) all.push_back(i < count ? number() : 0);
        return begin;
    };
    const auto anywhere = [&] { return place(random); };
    const auto nothing = [] { return 0.0; };
    const auto all_count = [] { return 1.0; };

    const LocalFrame frame{0.1, -0.2, 0.8, 0.6};
    const Flipped flips{list(kFlips, anywhere), list(kFlips, anywhere),
                        list(kFlips, [&] { return age(random); }), list(kFlips, anywhere),
                        list(kFlips, anywhere)};
    const FlipRows rows{list(kFlips, nothing), list(kFlips, nothing), list(kFlips, nothing),
                        list(kFlips, nothing)};
    kernels.place_flips(frame, {0.8, 0.6, 0.3, 0.9, 48}, flips, kFlips, rows);
    LaneSums sums{}, crossed{};
    kernels.add_flips({1.2, 2.5, 0.01, 0.2}, rows, kFlips, sums);

    const Crossed ends{list(kCrossings, anywhere), list(kCrossings, anywhere), list(kCrossings, anywhere),
                       list(kCrossings, anywhere)};
    const CrossingRows crossings{list(kCrossings, nothing), list(kCrossings, nothing),
                                 list(kCrossings, nothing), list(kCrossings, nothing),
                                 list(kCrossings, all_count)};
    kernels.place_crossings(frame, {9, 0.05, 0.2, 48}, ends, kCrossings, crossings, crossed);
    double *here = list(kCrossings, nothing), *beyond = list(kCrossings, nothing);
    all.push_back(kernels.find_wrong({0.1, 0.2, -0.3}, crossings, kCrossings, here, beyond));
    for (const LaneSums* lanes : {&sums, &crossed})
        for (const auto& of : *lanes) all.insert(all.end(), of, of + kLanes);
    return all;
}

TEST(FitLanes, are_bit_identical_for_every_instruction_set) {
    const auto expected = answers(kernels_for(sim::InstructionSet::kBaseline));
    for (const sim::InstructionSet set : sim::kInstructionSets) {
        if (!sim::has(set)) continue;
        const auto got = answers(kernels_for(set));
        ASSERT_EQ(got.size(), expected.size());
        EXPECT_EQ(std::memcmp(got.data(), expected.data(), got.size() * sizeof(double)), 0) << to_string(set);
    }
}

TEST(FitLanes, rank_each_key) {
    const std::vector<int> keys{5, -3, 8, 0, 7, 1, 2, 9, 4, 3, 6};
    for (const sim::InstructionSet set : sim::kInstructionSets) {
        if (!sim::has(set)) continue;
        std::vector<int> less(keys.size());
        kernels_for(set).find_order(keys.data(), static_cast<int>(keys.size()), less.data());
        EXPECT_EQ(less, (std::vector<int>{6, 0, 9, 1, 8, 2, 3, 10, 5, 4, 7}));
    }
}

// One flip, one cell ahead, at the given age and direction.
TEST(FitLanes, weigh_a_flip_by_place_age_and_direction) {
    const auto weight = [](double east, double age) {
        const double x[kLanes]{1}, y[kLanes]{}, then[kLanes]{age}, way[kLanes]{east}, north[kLanes]{};
        double s[kLanes], D[kLanes], ages[kLanes], weights[kLanes];
        const FlipRows rows{s, D, ages, weights};
        const Kernels& kernels = kernels_for(sim::InstructionSet::kBaseline);
        kernels.place_flips({0, 0, 1, 0}, {1, 0, 0.6, 0.9, 48}, {x, y, then, way, north}, 1, rows);
        EXPECT_EQ(D[0], 1);
        LaneSums sums{};
        kernels.add_flips({2, 2.5, 0.01, 0.2}, rows, 1, sums);
        return sums[0][0];  // sum of the weights
    };
    EXPECT_NEAR(weight(1, 0), 100, 1e-9);
    EXPECT_NEAR(weight(0.75, 0), 50, 1e-9);
    EXPECT_EQ(weight(0.6, 0), 0);
    EXPECT_EQ(weight(-1, 0), 0);
    EXPECT_NEAR(weight(1, 2), 1 / (0.01 + 0.04), 1e-9);
    EXPECT_EQ(weight(1, 5.1), 0);
}

}  // namespace
