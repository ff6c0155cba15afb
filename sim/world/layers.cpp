#include "sim/world/layers.h"

#include "sim/world/params.h"

namespace sim {
namespace {

template <class Number>
void set_sites(Layers<Number>& s, const Params& params, std::span<const std::uint8_t> has_data) {
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

}  // namespace

template <class Number>
Layers<Number> make_layers(const Grid& grid, const Params& params, std::span<const std::uint8_t> has_data) {
    CHECK(has_data.size() == grid.size());
    Layers<Number> s;
    s.grid = grid;
    s.bedrock = s.depth = s.rolling = s.velocity_x = s.velocity_y = s.first_slope = s.first_depth =
        s.smooth_depth = Field<Number>(grid);
    s.site = Field<Site>(grid);
    set_sites(s, params, has_data);
    return s;
}

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

template void continue_bedrock(Layers<float>&, const Params&);
template void continue_bedrock(Layers<double>&, const Params&);
template Layers<float> make_layers(const Grid&, const Params&, std::span<const std::uint8_t>);
template Layers<double> make_layers(const Grid&, const Params&, std::span<const std::uint8_t>);

}  // namespace sim
