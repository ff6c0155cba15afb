#include "sim/ground.h"

#include <algorithm>
#include <utility>

#include "sim/momentum/stages.h"
#include "sim/world/state.h"

namespace sim {

template <class Number>
void find_first_slope(Layers<Number>& s, const Params& params, int x0, int x1, int y0, int y1) {
    momentum::StageRows<Number> w{};
    w.nx = s.grid.nx, w.ny = s.grid.ny;
    w.borders = params.borders;
    w.c = momentum::constants_of(params, s.grid.dx, Substep<Number>{});
    w.bedrock = Rows<Number>(s.bedrock);
    w.u0.depth = Rows<Number>(s.depth), w.u0.rolling = Rows<Number>(s.rolling);
    const Span all{0, w.nx};
    for (int y = std::max(y0 - 1, 0); y <= std::min(y1 + 1, w.ny - 1); ++y)
        fill_halo<Number>(w, w.u0, y, all);
    for (int y = y0; y <= y1; ++y) {
        const auto ground = momentum::ground_rows(w, w.u0.depth, y);
        for (int x = x0; x <= x1; ++x)
            s.first_slope(x, y) = sqrt(Number(momentum::gradient<Number>(ground, x, w.c).squared()));
    }
}

void renew_ground(State& s) {
    if (!s.things || s.things->stale.empty()) return;
    const VertexBox box = std::exchange(s.things->stale, VertexBox{});
    continue_bedrock(s, s.params);
    const int x0 = std::max(box.x0 - 1, 0), x1 = std::min(box.x1 + 1, s.grid.nx - 1);
    const int y0 = std::max(box.y0 - 1, 0), y1 = std::min(box.y1 + 1, s.grid.ny - 1);
    find_first_slope(s, s.params, x0, x1, y0, y1);
    find_walls(s, box);
    s.tiles.wake(x0, x1, y0, y1);
    s.block_hashes.bedrock_is_stale = true;
}

template void find_first_slope(Layers<float>&, const Params&, int, int, int, int);
template void find_first_slope(Layers<double>&, const Params&, int, int, int, int);

}  // namespace sim
