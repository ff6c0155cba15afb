#include "render/mountain/drawn_mixture.h"

#include <algorithm>
#include <cmath>

#include "sim/world/mixture.h"

namespace render {

void drawn_mixture(const sim::View& world, std::vector<std::uint8_t>& into) {
    into.resize(world.mixture ? 2 * world.grid.size() : 0);
    if (!world.mixture) return;
    const int nx = world.grid.nx, ny = world.grid.ny;
    const auto shares_near = [&](int x, int y, const sim::Field<float>& layer, auto&& share_at) {
        if (layer(x, y) > 0) return share_at(world, x, y);
        float sum = 0, count = 0;
        for (int j = std::max(y - 1, 0); j <= std::min(y + 1, ny - 1); ++j)
            for (int i = std::max(x - 1, 0); i <= std::min(x + 1, nx - 1); ++i)
                if (layer(i, j) > 0) sum += share_at(world, i, j), count += 1;
        return count > 0 ? sum / count : 0.f;
    };
    const auto byte_of = [](float share) { return static_cast<std::uint8_t>(std::lround(share * 255)); };
    auto* to = into.data();
    for (int y = 0; y < ny; ++y)
        for (int x = 0; x < nx; ++x) {
            *to++ = byte_of(shares_near(x, y, world.depth, sim::share_at_surface));
            *to++ = byte_of(shares_near(x, y, world.rolling, sim::share_in_rolling));
        }
}

}  // namespace render
