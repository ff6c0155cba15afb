#include "sim/layers.h"

#include "sim/bcre/stages.h"
#include "sim/params.h"

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
Layers<Number> make_layers(const Grid& grid, const Params& params, std::span<const std::uint8_t> has_data) {
    CHECK(has_data.size() == grid.size());
    Layers<Number> s;
    s.grid = grid;
    s.bedrock = s.depth = s.rolling = s.velocity_x = s.velocity_y = s.first_slope = s.first_depth =
        Field<Number>(grid);
    s.site = Field<Site>(grid);
    set_sites(s, params, has_data);
    return s;
}

template <class Number>
void enclose(Layers<Number>& s, const Params& params) {
    continue_bedrock(s, params);
    Field<Number> drop_x(s.grid), drop_y(s.grid);
    bcre::Work<Number> w{};
    w.nx = s.grid.nx, w.ny = s.grid.ny;
    w.borders = params.borders;
    w.bedrock = Rows<Number>(s.bedrock);
    w.now.depth = Rows<Number>(s.depth), w.now.rolling = Rows<Number>(s.rolling);
    w.now.drop_x = Rows<Number>(drop_x), w.now.drop_y = Rows<Number>(drop_y);
    w.now.fall = Rows<Number>(s.first_slope);
    const Span all{0, w.nx};
    for (int y = 0; y < w.ny; ++y) fill_halo<Number>(w, w.now, y, all);
    for (int y = 0; y <= w.ny; ++y) along<Number>(all.faces(), find_drops<Number>(w, w.now, y));
    for (int y = 0; y < w.ny; ++y) {
        along<Number>(all, bcre::find_fall<Number>(w.now, y));
        for (int x = 0; x < w.nx; ++x) s.first_slope(x, y) /= s.grid.dx;
    }
    s.first_depth = s.depth;
}

template Layers<float> make_layers(const Grid&, const Params&, std::span<const std::uint8_t>);
template Layers<double> make_layers(const Grid&, const Params&, std::span<const std::uint8_t>);
template void enclose(Layers<float>&, const Params&);
template void enclose(Layers<double>&, const Params&);

}  // namespace sim
