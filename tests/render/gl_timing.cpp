#include <chrono>

#include <gtest/gtest.h>

#include "render/mountain/overview.h"
#include "tests/render/gl_scene.h"

// Frames whose stages are timed. No test checks the times themselves.

namespace render::test {
namespace {

World slope() {
    World world = make_world(24, 5, [](double x, double y) { return 0.4 * y + 0.1 * x; });
    world.rolling(12, 12) = 1;
    return world;
}

class Timed : public Gl, public testing::WithParamInterface<Timing> {};

TEST_P(Timed, frames_report_stage_times_and_look_unchanged) {
    const World world = slope();
    const Camera camera = overview(world.view());
    const Picture plain = draw(world, camera, Light(), Look());
    EXPECT_FALSE(renderer_->stage_times());

    renderer_->time_stages(GetParam());
    for (int frame = 0; frame < 3; ++frame) {
        const Picture timed = draw(world, camera, Light(), Look());
        EXPECT_TRUE(alike(timed, plain));
        const auto times = renderer_->stage_times();
        ASSERT_TRUE(times);
        double sum = 0;
        for (const double ms : times->ms) {
            EXPECT_GE(ms, 0);
            EXPECT_LT(ms, 60'000);
            sum += ms;
        }
        EXPECT_GT(sum, 0);
        EXPECT_NEAR(times->sum(), sum, 1e-9 * sum);
        EXPECT_NEAR(times->draw_ms(), sum - (*times)(Pass::kUpload) - (*times)(Pass::kRemesh), 1e-9 * sum);
    }
    renderer_->time_stages(Timing::kNone);
    draw(world, camera, Light(), Look());
    EXPECT_FALSE(renderer_->stage_times());
}

INSTANTIATE_TEST_SUITE_P(Ways, Timed, testing::Values(Timing::kFinish, Timing::kProcessor, Timing::kQueries),
                         [](const auto& way) {
                             return way.param == Timing::kFinish      ? "finish"
                                    : way.param == Timing::kProcessor ? "processor"
                                                                      : "queries";
                         });

TEST_F(Gl, times_of_the_passes_add_up_to_the_time_of_the_frame) {
    const World world = slope();
    const Camera camera = overview(world.view());
    renderer_->time_stages(Timing::kFinish);
    draw(world, camera, Light(), Look());
    renderer_->wait();
    const auto began = std::chrono::steady_clock::now();
    draw(world, camera, Light(), Look());
    const std::chrono::duration<double, std::milli> whole = std::chrono::steady_clock::now() - began;
    const auto times = renderer_->stage_times();
    ASSERT_TRUE(times);
    // The passes lie one after another within the call. The call also reads the frame back.
    EXPECT_LE(times->sum(), whole.count());
    EXPECT_GT((*times)(Pass::kTerrain), 0);
    EXPECT_GT((*times)(Pass::kTone), 0);
    renderer_->time_stages(Timing::kNone);
}

TEST_F(Gl, is_timed_by_the_wall_clock_with_a_cpu_renderer) {
    EXPECT_EQ(suitable_timing(), is_software_renderer() ? Timing::kFinish : Timing::kQueries);
    EXPECT_EQ(comparable_timing(), is_software_renderer() ? Timing::kProcessor : Timing::kQueries);
}

}  // namespace
}  // namespace render::test
