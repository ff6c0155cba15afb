#include "sim/weather/cast.h"

#include <algorithm>
#include <cmath>

#include "sim/weather/stream.h"
#include "sim/world/layers.h"

namespace sim::weather {

// H = max(z, H upstream − slope · step), in one sweep: upstream is between two of the vertices that were done before.
void cast(const Layers<float>& s, Direction to, double slope, Field<float>& over) {
    const Stream stream(s.grid, to);
    const float fall = static_cast<float>(static_cast<double>(stream.cell) * slope);
    const auto height = [&](int x, int y) { return s.bedrock(x, y) + s.depth(x, y); };
    const auto upstream = [&](int x, int y) {
        return x < 0 || y < 0 || x >= s.grid.nx || y >= s.grid.ny ? -1e9f : over(x, y) + height(x, y);
    };
    stream.each_row(
        s.grid, [](int) {},
        [&](int x, int y) {
            const float straight = upstream(x - stream.straight_x(), y - stream.straight_y()),
                        diagonal = upstream(x - stream.dx, y - stream.dy);
            const float z = height(x, y);
            over(x, y) = std::max((1 - stream.aside) * straight + stream.aside * diagonal - fall - z, 0.f);
        });
}

}  // namespace sim::weather
