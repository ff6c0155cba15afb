#include "sim/fields/flow_stage.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "sim/core/check.h"
#include "sim/core/workers.h"

namespace sim::fields {
namespace {

constexpr double kFarthest = 0.3;    // cells that a front may move in one part of a step
constexpr double kJumpShare = 0.25;  // jump that counts as a front, as a share of the initial speed
constexpr double kLeastJump = 0.02;  // sides per second, at any speed: more than the smooth field jumps by

}  // namespace

FlowStage::FlowStage(const Grid& grid, const TestFlow& flow, const FlowNumbers& numbers)
    : grid_(grid),
      side_((grid.nx - 1) * static_cast<double>(grid.dx)),
      flow_(flow),
      numbers_(numbers),
      jump_(static_cast<float>(std::max(kJumpShare * numbers.speed, kLeastJump) * side_)),
      mesh_(front::mesh_of(grid)),
      velocity_(grid.size()) {
    CHECK(grid.nx == grid.ny);
    begin_view();
}

void FlowStage::begin_view() {
    const front::Rule rule = numbers_.cut ? front::gradient_rule(jump_, grid_.dx) : front::uncut_rule();
    view_.emplace(mesh_, rule, numbers_.source, front::LayerRule{});
}

void FlowStage::set(const FlowNumbers& numbers) {
    const FlowNumbers before = std::exchange(numbers_, numbers);
    begins_anew_ = begins_anew_ || before.cut != numbers.cut || before.source != numbers.source;
}

void FlowStage::advance(double dt, Workers& workers) {
    if (std::exchange(begins_anew_, false)) {
        const front::TextureLayers::Memory textures = view_->layers().memory();
        begin_view();
        view_->layers().restore(textures);
    }
    flow_.flow_speed = numbers_.speed, flow_.front_speed = numbers_.front_speed,
    flow_.smooth = numbers_.smooth;
    const double cells = flow_.greatest_front_speed() * side_ / static_cast<double>(grid_.dx) * dt;
    const int parts = std::max(1, static_cast<int>(std::ceil(cells / kFarthest)));
    for (int part = 0; part < parts; ++part) {
        front_time_ += numbers_.front_speed * dt / parts;
        workers.each_band(mesh_.vertices(), [&](int first, int last) {
            for (int v = first; v < last; ++v)
                velocity_[v] = static_cast<float>(side_) *
                               flow_.velocity(glm::dvec2(mesh_.position[v]) / side_, front_time_);
        });
        view_->advance({velocity_, {}}, dt / parts, workers);
    }
}

}  // namespace sim::fields
