#include "sim/initial_state.h"

#include "sim/momentum/smooth_ground.h"
#include "sim/momentum/stages.h"
#include "sim/sweep/count_mass.h"
#include "sim/world/quanta.h"

namespace sim {
namespace {

// Bedrock goes on over the border as steep as inside; walls mirror it.
template <class Number>
void continue_bedrock(Layers<Number>& s, const Params& params) {
    const int nx = s.grid.nx, ny = s.grid.ny;
    Field<Number>& b = s.bedrock;
    const auto beyond = [&](Side side, Number edge, Number inner) {
        return params.borders[side] == Border::kWall ? edge : 2 * edge - inner;
    };
    for (int y = 0; y < ny; ++y) {
        b(-1, y) = beyond(kWest, b(0, y), b(1, y));
        b(nx, y) = beyond(kEast, b(nx - 1, y), b(nx - 2, y));
    }
    for (int x = -1; x <= nx; ++x) {
        b(x, -1) = beyond(kSouth, b(x, 0), b(x, 1));
        b(x, ny) = beyond(kNorth, b(x, ny - 1), b(x, ny - 2));
    }
}

}  // namespace

template <class Number>
void enclose(Layers<Number>& s, const Params& params) {
    continue_bedrock(s, params);
    momentum::StageRows<Number> w{};
    w.nx = s.grid.nx, w.ny = s.grid.ny;
    w.borders = params.borders;
    w.c = momentum::constants_of(params, s.grid.dx, Substep<Number>{});
    w.bedrock = Rows<Number>(s.bedrock);
    w.u0.depth = Rows<Number>(s.depth), w.u0.rolling = Rows<Number>(s.rolling);
    const Span all{0, w.nx};
    for (int y = 0; y < w.ny; ++y) fill_halo<Number>(w, w.u0, y, all);
    for (int y = 0; y < w.ny; ++y) {
        const auto ground = momentum::ground_rows(w, w.u0.depth, y);
        for (int x = 0; x < w.nx; ++x)
            s.first_slope(x, y) = sqrt(Number(momentum::gradient<Number>(ground, x, w.c).squared()));
    }
    s.first_depth = s.depth;
    if (has_momentum(params.model)) momentum::GroundSmoother::smooth_all(s);
}

State make_state(const InitialState& world, const Params& params) {
    const Grid& grid = world.grid;
    CHECK(world.bedrock.size() == grid.size() && world.depth.size() == grid.size());
    CHECK(world.rolling.size() == grid.size() && world.has_data.size() == grid.size());

    State s;
    static_cast<Layers<float>&>(s) = make_layers<float>(grid, params, world.has_data);
    s.params = params;
    s.datum = world.datum;
    s.seed = world.seed;
    for (int y = 0; y < grid.ny; ++y)
        for (int x = 0; x < grid.nx; ++x) {
            const std::size_t i =
                static_cast<std::size_t>(y) * static_cast<std::size_t>(grid.nx) + static_cast<std::size_t>(x);
            s.bedrock(x, y) = world.bedrock[i];
            if (s.site(x, y) != Site::kGround) continue;
            s.depth(x, y) = nearest_quanta(world.depth[i]);
            s.rolling(x, y) = nearest_quanta(world.rolling[i]);
        }
    if (world.lower) s.mixture = make_mixture(s, world.lower->params, world.lower->depth);
    enclose(s, params);
    count_mass(s);
    s.ledger.initial = s.ledger.standing + s.ledger.rolling;
    if (s.mixture) s.mixture->ledger.initial = s.mixture->ledger.standing;
    return s;
}

template void enclose(Layers<float>&, const Params&);
template void enclose(Layers<double>&, const Params&);

}  // namespace sim
