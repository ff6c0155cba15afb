#include <cmath>
#include <optional>
#include <stdexcept>

#include <gtest/gtest.h>

#include "render/frame.h"
#include "render/mountain/overview.h"
#include "sim/core/workers.h"
#include "tests/baselines/image_baseline.h"
#include "tests/render/world.h"
#include "tests/support/places.h"
#include "tests/support/renderer.h"

// One frame for each pass, made so that the pass has something to say in it.

namespace baselines {
namespace {

using render::Camera;
using render::Light;
using render::Look;
using render::Marks;
using render::Overlay;
using render::Quality;
using render::test::make_world;
using render::test::World;

constexpr int kWidth = 240, kHeight = 160;  // pixels

class Pass : public testing::Test {
  protected:
    void SetUp() override {
        static const auto context = render::HeadlessContext::create("auto");
        ASSERT_TRUE(context) << context.error();
        ASSERT_NO_FATAL_FAILURE(support::make_renderer(renderer_, Quality::kFast));
    }

    render::Picture draw(const World& world, const Camera& camera, const Light& light = {},
                         const Look& look = {}, const Marks& marks = {},
                         const sim::front::FlowView* flow = nullptr) {
        renderer_->draw({world.view(), camera, light, look, marks, flow, kWidth, kHeight});
        return renderer_->read_back();
    }

    std::optional<render::Renderer> renderer_;
};

// A slope with a gully, half of it under snow, and a heap that moves.
World slope() {
    World world = make_world(
        48, 5, [](double x, double y) { return 0.5 * y + 14 * std::sin(x / 25) * std::cos(y / 60); });
    for (int y = 0; y <= 48; ++y)
        for (int x = 0; x <= 48; ++x) {
            world.depth(x, y) = y > 20 ? 0.9f : 0;
            if (std::hypot(x - 24, y - 26) < 9)
                world.rolling(x, y) = 1.5f, world.velocity_x(x, y) = 2, world.velocity_y(x, y) = -8;
        }
    return world;
}

Look plain() {
    Look look;
    look.detail = 0;
    return look;
}

Camera low_camera() {
    return {{120, 60, 40}, 200, 4, 160, 45};
}

TEST_F(Pass, terrain_shades_ground_snow_and_flow) {
    const World world = slope();
    EXPECT_TRUE(matches_baseline(draw(world, render::overview(world.view())), "pass_terrain"));
}

TEST_F(Pass, terrain_without_detail_shows_plain_colours) {
    const World world = slope();
    EXPECT_TRUE(
        matches_baseline(draw(world, render::overview(world.view()), {}, plain()), "pass_terrain_plain"));
}

TEST_F(Pass, shadow_falls_behind_ridges_at_a_low_sun) {
    const World world = slope();
    EXPECT_TRUE(
        matches_baseline(draw(world, render::overview(world.view()), {250, 12}, plain()), "pass_shadow"));
}

TEST_F(Pass, openness_darkens_a_gully_under_a_high_sun) {
    const World world =
        make_world(48, 5, [](double x, double) { return std::min(std::abs(x - 120), 50.0) * 1.4; });
    EXPECT_TRUE(
        matches_baseline(draw(world, render::overview(world.view()), {180, 88}, plain()), "pass_openness"));
}

TEST_F(Pass, walls_and_sky_surround_a_low_view) {
    const World world = slope();
    EXPECT_TRUE(matches_baseline(draw(world, low_camera()), "pass_walls_and_sky"));
}

TEST_F(Pass, tone_keeps_detail_in_bright_snow) {
    World world = slope();
    world.depth.fill(2);
    EXPECT_TRUE(matches_baseline(draw(world, render::overview(world.view()), {135, 65}), "pass_tone"));
}

TEST_F(Pass, marks_lie_on_the_ground) {
    const World world = slope();
    Marks marks;
    marks.contours = true;
    marks.ring = render::Ring{{130, 90}, 35, {1, 0.5, 0.1}};
    EXPECT_TRUE(matches_baseline(draw(world, render::overview(world.view()), {}, {}, marks), "pass_marks"));
}

TEST_F(Pass, overlays_colour_what_they_measure) {
    const World world = slope();
    for (const auto& [overlay, name] : {std::pair{Overlay::kSlope, "slope"},
                                        {Overlay::kStanding, "standing"},
                                        {Overlay::kRolling, "rolling"},
                                        {Overlay::kSpeed, "speed"},
                                        {Overlay::kPressure, "pressure"}}) {
        Marks marks;
        marks.density = glm::vec2(200);
        marks.overlay = overlay;
        EXPECT_TRUE(matches_baseline(draw(world, render::overview(world.view()), {}, {}, marks),
                                     std::string("pass_overlay_") + name));
    }
}

// Two halves that slide past each other, for a second.
class FlowPass : public Pass {
  protected:
    void SetUp() override {
        Pass::SetUp();
        for (const auto pattern : {render::FlowPattern::kSnow, render::FlowPattern::kCheckerboard}) {
            render::Look look;
            look.flow = render::FlowLook{pattern};
            const auto loaded = renderer_->load(look, false);
            ASSERT_TRUE(loaded) << loaded.error();
        }
        std::vector<glm::vec2> velocity;
        for (const glm::vec2& at : mesh_.position) velocity.emplace_back(at.x > 122.5f ? 6 : -6, -10);
        for (int i = 0; i < 60; ++i) flow_.advance({velocity, {}}, 1 / 60.0, workers_);
    }

    static Look look(render::FlowPattern pattern, bool everywhere) {
        Look look;
        look.flow = render::FlowLook{pattern, 9, everywhere};
        return look;
    }

    const World world_ = slope();
    const sim::front::Mesh mesh_ = sim::front::mesh_of(world_.grid);
    sim::Workers workers_{1};
    sim::front::FlowView flow_{mesh_, sim::front::gradient_rule(1, 5), sim::front::PointSource::kFit, {}};
};

TEST_F(FlowPass, draws_debris_on_the_rolling_layer) {
    EXPECT_TRUE(matches_baseline(draw(world_, render::overview(world_.view()), {},
                                      look(render::FlowPattern::kSnow, false), {}, &flow_),
                                 "pass_flow_on_layer"));
}

TEST_F(FlowPass, draws_a_pattern_everywhere_and_its_cut_mesh) {
    Marks marks;
    marks.flow_mesh = true;
    EXPECT_TRUE(matches_baseline(draw(world_, render::overview(world_.view()), {},
                                      look(render::FlowPattern::kCheckerboard, true), marks, &flow_),
                                 "pass_flow_mesh"));
}

TEST_F(FlowPass, colours_stretch) {
    Marks marks;
    marks.overlay = Overlay::kStretch;
    EXPECT_TRUE(matches_baseline(draw(world_, render::overview(world_.view()), {},
                                      look(render::FlowPattern::kCheckerboard, true), marks, &flow_),
                                 "pass_flow_stretch"));
}

TEST_F(Pass, comparison_notices_a_sun_that_is_four_degrees_lower) {
    const World world = slope();
    const Camera camera = render::overview(world.view());
    const auto frame = draw(world, camera, {135, 40}, plain());
    EXPECT_TRUE(are_alike(frame, draw(world, camera, {135, 40}, plain())));
    EXPECT_FALSE(are_alike(frame, draw(world, camera, {135, 36}, plain())));
}

}  // namespace
}  // namespace baselines
