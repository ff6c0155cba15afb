#include "sim/world/outlets.h"

#include "sim/core/grid.h"
#include "sim/world/layers.h"

namespace sim {

Outlets::Outlets(const Grid& grid, const Field<Site>& site) {
    const auto is = [&](int x, int y, Site what) { return site(x, y) == what; };
    for (int y = 0; y < grid.ny; ++y) {
        first_face.push_back(static_cast<int>(faces.size()));
        first_drain.push_back(static_cast<int>(drains.size()));
        for (int x = 0; x < grid.nx; ++x) {
            const std::pair<Way, Site> beside[] = {{Way::kEast, site(x + 1, y)},
                                                   {Way::kWest, site(x - 1, y)},
                                                   {Way::kNorth, site(x, y + 1)},
                                                   {Way::kSouth, site(x, y - 1)}};
            bool has_ground = false;
            for (const auto& [way, there] : beside) {
                if (is(x, y, Site::kGround) && there == Site::kDrain) faces.push_back({x, y, way});
                has_ground = has_ground || there == Site::kGround;
            }
            if (is(x, y, Site::kDrain) && has_ground) drains.push_back(x);
        }
    }
    first_face.push_back(static_cast<int>(faces.size()));
    first_drain.push_back(static_cast<int>(drains.size()));
}

}  // namespace sim
