#include <gtest/gtest.h>

#include "render/overview.h"
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
        EXPECT_EQ(timed.pixels, plain.pixels);
        const auto times = renderer_->stage_times();
        ASSERT_TRUE(times);
        for (const double ms : {times->upload_ms, times->remesh_ms, times->draw_ms}) {
            EXPECT_GE(ms, 0);
            EXPECT_LT(ms, 60'000);
        }
        EXPECT_GT(times->upload_ms + times->draw_ms, 0);
    }
    renderer_->time_stages(Timing::kNone);
    draw(world, camera, Light(), Look());
    EXPECT_FALSE(renderer_->stage_times());
}

INSTANTIATE_TEST_SUITE_P(Ways, Timed, testing::Values(Timing::kFinish, Timing::kQueries),
                         [](const auto& way) { return way.param == Timing::kFinish ? "finish" : "queries"; });

TEST_F(Gl, is_timed_by_the_wall_clock_with_a_cpu_renderer) {
    EXPECT_EQ(suitable_timing(), is_software_renderer() ? Timing::kFinish : Timing::kQueries);
}

}  // namespace
}  // namespace render::test
