#include "sim/front/world_fronts.h"

#include "sim/workers.h"

namespace sim::front {
namespace {

Rule level_rule(float level) {
    Rule rule;
    rule.kind = Rule::Kind::kLevel;
    rule.level = level;
    return rule;
}

}  // namespace

WorldFronts::WorldFronts(const Grid& grid, float visible, const LayerRule& layers)
    : visible_(visible),
      mesh_(mesh_of(grid)),
      view_(mesh_, level_rule(visible), Source::kLevel, layers),
      velocity_(grid.size()),
      rolling_(grid.size()) {}

void WorldFronts::advance(const View& world, double dt, Workers& workers) {
    const int columns = world.grid.nx;
    workers.each_band(world.grid.ny, [&](int first, int last) {
        for (int y = first; y < last; ++y) {
            const float* r = world.rolling.row(y);
            const float *u = world.velocity_x.row(y), *v = world.velocity_y.row(y);
            const auto row = static_cast<std::size_t>(y) * static_cast<std::size_t>(columns);
            for (int x = 0; x < columns; ++x) {
                const bool moves = r[x] >= visible_ && u[x] * u[x] + v[x] * v[x] >= kLeastSpeed * kLeastSpeed;
                velocity_[row + static_cast<std::size_t>(x)] =
                    moves ? glm::vec2(u[x], v[x]) : glm::vec2(0, 0);
                rolling_[row + static_cast<std::size_t>(x)] = r[x];
            }
        }
    });
    view_.advance({velocity_, rolling_}, dt, workers);
}

}  // namespace sim::front
