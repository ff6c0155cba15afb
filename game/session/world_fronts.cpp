#include "game/session/world_fronts.h"

#include <utility>

#include "sim/core/check.h"
#include "sim/core/workers.h"

namespace game {
namespace {

sim::front::Rule level_rule(float level) {
    sim::front::Rule rule;
    rule.kind = sim::front::Rule::Kind::kLevel;
    rule.level = level;
    return rule;
}

}  // namespace

WorldFronts::WorldFronts(const sim::Grid& grid, float visible, const sim::front::LayerRule& layers,
                         std::span<const float> undisturbed)
    : visible_(visible),
      rule_(layers),
      mesh_(sim::front::mesh_of(grid)),
      velocity_(grid.size()),
      rolling_(grid.size()),
      undisturbed_(undisturbed),
      rise_(undisturbed_.size()) {
    CHECK(undisturbed_.empty() || undisturbed_.size() == grid.size());
    begin();
}

void WorldFronts::begin() {
    view_.emplace(mesh_, level_rule(visible_), sim::front::PointSource::kLevel, rule_);
    view_->set_rise(rise_);
}

void WorldFronts::track(const sim::View& world, double dt, sim::Workers& workers) {
    read(world, workers);
    view_->track(flow(), dt, workers);
}

void WorldFronts::restore(const sim::View& world, const sim::front::TextureLayers::Memory& memory,
                          sim::Workers& workers) {
    begin_anew(world, workers);
    view_->layers().restore(memory);
}

// Points at a level do not depend on the past: a new tracker finds the same ones.
void WorldFronts::begin_anew(const sim::View& world, sim::Workers& workers) {
    begin();
    track(world, 1, workers);
}

// Row by row, without the halo.
void WorldFronts::read(const sim::View& world, sim::Workers& workers) {
    const auto columns = static_cast<std::size_t>(world.grid.nx);
    workers.each_band(world.grid.ny, [&](int begin, int end) {
        for (int y = begin; y < end; ++y) {
            const float* r = world.rolling.row(y);
            const float *u = world.velocity_x.row(y), *v = world.velocity_y.row(y);
            glm::vec2* velocity = velocity_.data() + static_cast<std::size_t>(y) * columns;
            float* rolling = rolling_.data() + static_cast<std::size_t>(y) * columns;
            for (std::size_t x = 0; x < columns; ++x) {
                const bool moves = r[x] > visible_ && u[x] * u[x] + v[x] * v[x] >= kLeastSpeed * kLeastSpeed;
                velocity[x] = moves ? glm::vec2(u[x], v[x]) : glm::vec2(0, 0);
                rolling[x] = r[x];
            }
            if (rise_.empty()) continue;
            const float *depth = world.depth.row(y),
                        *undisturbed = undisturbed_.data() + static_cast<std::size_t>(y) * columns;
            float* rise = rise_.data() + static_cast<std::size_t>(y) * columns;
            for (std::size_t x = 0; x < columns; ++x) rise[x] = depth[x] - undisturbed[x];
        }
    });
}

}  // namespace game
