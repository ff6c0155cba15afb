#include <cmath>

#include <gtest/gtest.h>

#include "sim/momentum/smooth_ground.h"
#include "tests/support/worlds.h"

// The smoothed ground, from which models with momentum take inclination and bend.

namespace {

using sim::Model;
using sim::momentum::GroundSmoother;
using support::lively;
using support::Play;

TEST(SmoothGround, of_a_plane_is_the_plane_up_to_the_border) {
    for (const float dx : {0.5f, 2.f, 12.5f, 50.f}) {
        Play play(support::plane(40, dx, 0.5, 1), lively(Model::kVoellmy));
        for (int y = 0; y <= 40; ++y)
            for (int x = 0; x <= 40; ++x) ASSERT_EQ(play.state.smooth_depth(x, y), 1) << dx;
    }
}

TEST(SmoothGround, spreads_a_spike_by_seven_metres_or_six_cells_and_keeps_its_volume) {
    for (const float dx : {0.5f, 2.f, 5.f}) {
        constexpr int kMiddle = 40;
        support::Ground ground({2 * kMiddle + 1, 2 * kMiddle + 1, dx});
        ground.depth[ground.at(kMiddle, kMiddle)] = 8;
        Play play(ground, lively(Model::kVoellmy));
        double sum = 0, variance = 0;
        for (int y = 0; y <= 2 * kMiddle; ++y)
            for (int x = 0; x <= 2 * kMiddle; ++x) {
                const double s = static_cast<double>(play.state.smooth_depth(x, y));
                sum += s;
                variance += s * (x - kMiddle) * (x - kMiddle) * dx * dx;
            }
        EXPECT_NEAR(sum, 8, 0.01) << dx;
        EXPECT_NEAR(std::sqrt(variance / sum), std::min(7.f, 6 * dx), 0.15) << dx;
    }
}

// Found tile by tile where something moved, it is what all of the ground would give.
TEST(SmoothGround, follows_what_moves_every_fifteen_ticks_and_is_that_of_the_whole_ground) {
    for (const bool plain : {false, true}) {
        Play play(support::rough(150, 2, 4), lively(Model::kBcreInertial),
                  {.threads = 2, .plain = plain, .tile_width = 32, .tile_height = 8});
        sim::Command dig = support::pour_at(60, 60, 10, 8, 0.1);
        dig.kind = sim::CommandKind::kDig;
        dig = support::of_its_kind(dig);
        const sim::Command pour = support::pour_at(200, 220, 12, 60, 1);
        int changes = 0;
        for (int tick = 0; tick < 90; ++tick) {
            const sim::Field<float> had = play.state.smooth_depth;
            sim::Layers<float> whole = play.state;
            play.ticks(1, tick == 31   ? std::span(&dig, 1)
                          : tick == 40 ? std::span(&pour, 1)
                                       : std::span<const sim::Command>{});
            if (tick % sim::momentum::kTicksPerSmoothing != 0) {
                ASSERT_TRUE(support::same_bits(had, play.state.smooth_depth)) << tick;
                continue;
            }
            GroundSmoother::smooth_all(whole);
            if (tick != 45) {  // the pour still runs then
                ASSERT_TRUE(support::same_bits(whole.smooth_depth, play.state.smooth_depth)) << tick;
            }
            changes += !support::same_bits(had, play.state.smooth_depth);
        }
        EXPECT_GE(changes, 4);
    }
}

}  // namespace
