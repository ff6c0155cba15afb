#include "sim/fields/flow_stage.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>

#include "sim/core/workers.h"

namespace {

using sim::fields::FlowNumbers;
using sim::fields::FlowStage;

constexpr int kSquares = 20;
constexpr double kSide = 100;  // m

class Stage : public testing::Test {
  protected:
    // Root mean square distance of the points from the front, cells. `front_time`: the front's clock, s.
    double error(const sim::front::FlowView& view, const sim::fields::TestFlow& flow,
                 double front_time) const {
        double sum = 0;
        for (const auto& point : view.tracker().points()) {
            const glm::dvec2 at(view.tracker().position(point));
            const double away = flow.distance(at / kSide, front_time) * kSquares;
            sum += away * away;
        }
        return std::sqrt(sum / static_cast<double>(view.tracker().points().size()));
    }

    const sim::Grid grid{kSquares + 1, kSquares + 1, static_cast<float>(kSide / kSquares)};
    sim::Workers workers{1};
};

TEST_F(Stage, scales_a_flow_to_ground_of_any_size) {
    const auto flow = sim::fields::swinging(30);
    FlowStage stage(grid, flow, {});
    for (int i = 0; i < 300; ++i) stage.advance(1 / 60.0, workers);
    EXPECT_GT(stage.view().tracker().points().size(), 30u);
    EXPECT_LT(error(stage.view(), flow, 5), 0.1);
    // At 0.2 sides per second the texture has moved one side along the line.
    EXPECT_NEAR(stage.view().layers().offsets()[0][0].x, 0.2 * kSide * 5 * std::cos(3.14159265 / 6), 8);
}

TEST_F(Stage, lets_speeds_change_while_it_runs) {
    const auto flow = sim::fields::pinwheel();
    FlowStage stage(grid, flow, {});
    double front_time = 0;
    for (const double front_speed : {1., 3., 0., -2., 0.5}) {
        FlowNumbers numbers;
        numbers.front_speed = front_speed;
        stage.set(numbers);
        for (int i = 0; i < 120; ++i) stage.advance(1 / 60.0, workers);
        front_time += 2 * front_speed;
        // At rest, velocities only tell which edges the front crosses; when it starts again its speed is
        // unknown.
        const bool guessed = front_speed == 0 || front_speed == 0.5;
        EXPECT_LT(error(stage.view(), flow, front_time), guessed ? 0.4 : 0.12) << front_speed;
    }
}

TEST_F(Stage, tracks_a_fast_front_better_in_parts_of_a_step) {
    // Up to 0.9 cells in a step.
    const auto flow = sim::fields::swinging(30);
    constexpr double kStep = 1 / 15.0;  // s
    FlowNumbers numbers;
    numbers.front_speed = 4;
    FlowStage stage(grid, flow, numbers);
    sim::front::FlowView whole(stage.view().mesh(), sim::front::gradient_rule(5, grid.dx),
                               sim::front::PointSource::kFit, {});
    std::vector<glm::vec2> velocity(grid.size());
    double in_parts = 0, in_one = 0;
    for (int i = 1; i <= 120; ++i) {
        const double front_time = 4 * i * kStep;
        stage.advance(kStep, workers);
        for (std::size_t v = 0; v < velocity.size(); ++v)
            velocity[v] = static_cast<float>(kSide) *
                          flow.velocity(glm::dvec2(whole.mesh().position[v]) / kSide, front_time);
        whole.advance({velocity, {}}, kStep, workers);
        if (i <= 30) continue;
        in_parts += error(stage.view(), flow, front_time) / 90;
        in_one += error(whole, flow, front_time) / 90;
    }
    EXPECT_LT(in_parts, 0.12);
    EXPECT_GT(in_one, 1.5 * in_parts);
}

TEST_F(Stage, starts_cutting_without_resetting_its_textures) {
    FlowNumbers numbers;
    numbers.cut = false;
    FlowStage stage(grid, sim::fields::disc(), numbers);
    for (int i = 0; i < 120; ++i) stage.advance(1 / 60.0, workers);
    EXPECT_TRUE(stage.view().tracker().points().empty());
    const auto before = stage.view().layers().memory();
    numbers.cut = true;
    numbers.source = sim::front::PointSource::kPaper;
    stage.set(numbers);
    const auto after = stage.view().layers().memory();
    EXPECT_EQ(std::memcmp(before.offset.data(), after.offset.data(),
                          before.offset.size() * sizeof(before.offset[0])),
              0);
    for (int i = 0; i < 60; ++i) stage.advance(1 / 60.0, workers);
    EXPECT_GT(stage.view().tracker().points().size(), 15u);
    EXPECT_EQ(stage.view().tracker().source(), sim::front::PointSource::kPaper);
}

TEST_F(Stage, is_bit_identical_for_any_number_of_threads) {
    const auto played = [&](int threads) {
        sim::Workers crew(threads);
        FlowNumbers numbers;
        numbers.smooth = 0.03;
        FlowStage stage(grid, sim::fields::crowd(), numbers);
        for (int i = 0; i < 100; ++i) stage.advance(1 / 60.0, crew);
        return stage.view().layers().memory().offset;
    };
    const auto one = played(1), three = played(3);
    EXPECT_EQ(std::memcmp(one.data(), three.data(), one.size() * sizeof(one[0])), 0);
}

TEST_F(Stage, at_rest_has_no_cut_edges) {
    FlowNumbers numbers;
    numbers.speed = 0;
    FlowStage stage(grid, sim::fields::pinwheel(), numbers);
    for (int i = 0; i < 5; ++i) stage.advance(1 / 60.0, workers);
    EXPECT_TRUE(stage.view().tracker().points().empty());
    numbers.speed = 0.2;
    stage.set(numbers);
    stage.advance(1 / 60.0, workers);
    EXPECT_GT(stage.view().tracker().points().size(), 30u);
}

}  // namespace
