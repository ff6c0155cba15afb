#include "render/mountain/height_range.h"

#include <algorithm>
#include <limits>

namespace render {

HeightRange height_range(const sim::View& world) {
    const sim::Field<float>& bedrock = world.things ? world.things->natural : world.bedrock;
    HeightRange range{std::numeric_limits<float>::max(), std::numeric_limits<float>::lowest()};
    for (int y = 0; y < world.grid.ny; ++y) {
        for (int x = 0; x < world.grid.nx; ++x) {
            if (world.site(x, y) == sim::Site::kDrain) continue;
            range.lowest = std::min(range.lowest, bedrock(x, y));
            range.highest = std::max(range.highest, bedrock(x, y));
        }
    }
    return range.lowest > range.highest ? HeightRange{} : range;
}

}  // namespace render
