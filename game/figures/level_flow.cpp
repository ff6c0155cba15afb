#include "game/figures/level_flow.h"

#include <cmath>
#include <vector>

namespace game {
namespace {

constexpr double kStepsPerSecond = 60;
constexpr float kJump = 0.05f;  // m/s; across the fronts it is at least 0.14
constexpr float kNever = 1e9f;  // m/s, is no jump

sim::front::Rule rule_of(float cell, bool cut) {
    return sim::front::gradient_rule(cut ? kJump : kNever, cell);
}

sim::State level(const sim::Grid& grid) {
    const std::vector<float> nothing(grid.size(), 0.f);
    const std::vector<std::uint8_t> has_data(grid.size(), 1);
    return sim::make_state({grid, 0, nothing, nothing, nothing, has_data}, sim::Params{});
}

}  // namespace

LevelFlow::LevelFlow(int squares, bool cut)
    : grid_{squares + 1, squares + 1, 1.f / static_cast<float>(squares)},
      mesh_(sim::front::mesh_of(grid_)),
      view_(mesh_, rule_of(grid_.dx, cut), sim::front::Source::kFit, {}),
      ground_(level(grid_)) {}

void LevelFlow::advance(const sim::fields::TestFlow& flow, double seconds, sim::Workers& workers) {
    std::vector<glm::vec2> velocity(mesh_.position.size());
    const auto steps = std::lround(seconds * kStepsPerSecond);
    for (int step = 1; step <= steps; ++step) {
        for (std::size_t v = 0; v < velocity.size(); ++v)
            velocity[v] = flow.velocity(glm::dvec2(mesh_.position[v]), step / kStepsPerSecond);
        view_.advance({velocity, {}}, 1 / kStepsPerSecond, workers);
    }
}

}  // namespace game
