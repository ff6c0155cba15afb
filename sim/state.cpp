#include "sim/state.h"

#include <algorithm>

#include "sim/bcre/stages.h"
#include "sim/borders.h"
#include "sim/params.h"
#include "sim/quanta.h"
#include "sim/scratch.h"

namespace sim {
namespace {

void set_sites(State& s, const Params& params, std::span<const std::uint8_t> has_data) {
    const int nx = s.grid.nx, ny = s.grid.ny;
    const auto halo = [&](Side side) {
        return params.borders[side] == Border::kWall ? Site::kWall : Site::kDrain;
    };
    for (int y = 0; y < ny; ++y) s.site(-1, y) = halo(kWest), s.site(nx, y) = halo(kEast);
    for (int x = -1; x <= nx; ++x) s.site(x, -1) = halo(kSouth), s.site(x, ny) = halo(kNorth);
    for (int y = 0; y < ny; ++y)
        for (int x = 0; x < nx; ++x)
            s.site(x, y) = has_data[static_cast<std::size_t>(y) * static_cast<std::size_t>(nx) +
                                    static_cast<std::size_t>(x)]
                               ? Site::kGround
                               : Site::kDrain;
}

// Bedrock goes on over the border as steep as inside; walls mirror it.
void continue_bedrock(State& s, const Params& params) {
    const int nx = s.grid.nx, ny = s.grid.ny;
    Field<float>& b = s.bedrock;
    const auto beyond = [&](Side side, float edge, float inner) {
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

void remember_first_slope(State& s) {
    Scratch scratch(s);
    fill_borders(s, s.params);
    bcre::lower_slope(s, scratch, 0, s.grid.ny);
    for (int y = 0; y < s.grid.ny; ++y) std::copy_n(scratch.slope.row(y), s.grid.nx, s.first_slope.row(y));
}

}  // namespace

State make_state(const World& world, const Params& params) {
    const Grid& grid = world.grid;
    CHECK(world.bedrock.size() == grid.size() && world.depth.size() == grid.size());
    CHECK(world.rolling.size() == grid.size() && world.has_data.size() == grid.size());

    State s;
    s.grid = grid;
    s.params = params;
    s.datum = world.datum;
    s.seed = world.seed;
    s.bedrock = s.depth = s.rolling = s.velocity_x = s.velocity_y = s.first_slope = Field<float>(grid);
    s.site = Field<Site>(grid);
    set_sites(s, params, world.has_data);
    for (int y = 0; y < grid.ny; ++y)
        for (int x = 0; x < grid.nx; ++x) {
            const std::size_t i =
                static_cast<std::size_t>(y) * static_cast<std::size_t>(grid.nx) + static_cast<std::size_t>(x);
            s.bedrock(x, y) = world.bedrock[i];
            if (s.site(x, y) != Site::kGround) continue;
            s.depth(x, y) = nearest_quanta(world.depth[i]);
            s.rolling(x, y) = nearest_quanta(world.rolling[i]);
        }
    continue_bedrock(s, params);
    remember_first_slope(s);
    count_mass(s);
    s.ledger.initial = s.ledger.standing + s.ledger.rolling;
    return s;
}

bool at_rest(const State& state) {
    return state.ledger.rolling == 0 && state.sources.empty();
}

}  // namespace sim
