#pragma once

#include <algorithm>

#include "sim/core/angle.h"
#include "sim/world/disc.h"
#include "sim/world/state.h"
#include "sim/world/things.h"

namespace sim {

// The slopes of ground that a command acts on, as squared tangents of |∇(b + d)|, central.
class SlopeFilter {
  public:
    explicit SlopeFilter(const Command& command)
        : takes_all_(command.least_slope == Command::kNoLeast && command.most_slope == Command::kNoMost),
          least_(direction_of(command.least_slope)),
          most_(direction_of(command.most_slope)) {}

    bool takes_all() const { return takes_all_; }
    bool takes(const State& s, int x, int y) const {
        if (takes_all_) return true;
        const auto rise = [&](int x0, int y0, int x1, int y1) {
            return static_cast<double>((s.bedrock(x1, y1) - s.bedrock(x0, y0)) +
                                       (s.depth(x1, y1) - s.depth(x0, y0)));
        };
        const int west = std::max(x - 1, 0), east = std::min(x + 1, s.grid.nx - 1);
        const int south = std::max(y - 1, 0), north = std::min(y + 1, s.grid.ny - 1);
        const auto dx = static_cast<double>(s.grid.dx);
        const double along_x = rise(west, y, east, y) / ((east - west) * dx);
        const double along_y = rise(x, south, x, north) / ((north - south) * dx);
        const double squared = along_x * along_x + along_y * along_y;
        return squared * (least_.y * least_.y) >= least_.x * least_.x &&
               squared * (most_.y * most_.y) <= most_.x * most_.x;
    }

  private:
    bool takes_all_;
    Direction least_, most_;  // of a slope: sine and cosine
};

// Calls visit(x, y, weight) for each ground vertex under the disc of a command whose slope it takes, and wakes what
// lies there.
template <class Visit>
void each_ground(State& s, const Command& command, Profile profile, Visit&& visit) {
    const Disc disc(command, s.grid.dx);
    const SlopeFilter filter(command);
    s.tiles.wake(std::max(disc.x0, 0), std::min(disc.x1, s.grid.nx - 1), std::max(disc.y0, 0),
                 std::min(disc.y1, s.grid.ny - 1));
    disc.each_vertex(s.grid, profile, [&](int x, int y, double weight) {
        if (s.site(x, y) == Site::kGround && filter.takes(s, x, y)) visit(x, y, weight);
    });
}

}  // namespace sim
