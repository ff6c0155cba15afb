#include <algorithm>
#include <vector>

#include "sim/core/check.h"
#include "sim/front/point_estimator.h"

// Source kLevel: the point of an edge where a scalar s, known at the vertices and linear in between, reaches
// its level L. On an edge from a to b,
//
//     f = (L − s_a) / (s_b − s_a),     df/dt = −(∂s/∂t at f) / (s_b − s_a)

namespace sim::front {
namespace {

class LevelLocator : public PointEstimator {
  public:
    LevelLocator(const Mesh& mesh, float level) : mesh_(mesh), level_(level) {}

    void locate(const TrackedMoment& now, std::span<Point> points) override {
        const std::span<const float> s = now.flow.scalar;
        CHECK(s.size() == mesh_.position.size());
        const bool first = before_.empty();
        for (Point& point : points) {
            const auto [a, b] = mesh_.edge[point.edge];
            const float rise = s[b] - s[a];
            // If velocities cut an edge that the level does not, take the end that is nearer to the level.
            point.f = rise == 0 ? 0.5f : std::clamp((level_ - s[a]) / rise, 0.f, 1.f);
            if (first || rise == 0) continue;
            const float gain = (1 - point.f) * (s[a] - before_[a]) + point.f * (s[b] - before_[b]);
            point.speed = -gain / static_cast<float>(now.dt) / rise * mesh_.length[point.edge];
        }
        before_.assign(s.begin(), s.end());
    }

  private:
    const Mesh& mesh_;
    float level_;
    std::vector<float> before_;  // the scalar of the previous moment
};

}  // namespace

std::unique_ptr<PointEstimator> level_estimator(const Mesh& mesh, float level) {
    return std::make_unique<LevelLocator>(mesh, level);
}

}  // namespace sim::front
