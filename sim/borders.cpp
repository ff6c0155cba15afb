#include "sim/borders.h"

#include "sim/layers.h"
#include "sim/params.h"

namespace sim {
namespace {

// One halo vertex from the border vertex beside it. `across` is the velocity component through the border.
template <class Number>
void fill(Layers<Number>& s, Border border, int hx, int hy, int x, int y, Field<Number>& across,
          Field<Number>& along) {
    const bool wall = border == Border::kWall;
    s.depth(hx, hy) = border == Border::kSink ? Number{0} : s.depth(x, y);
    s.rolling(hx, hy) = wall ? s.rolling(x, y) : Number{0};
    across(hx, hy) = wall ? -across(x, y) : Number{0};
    along(hx, hy) = wall ? along(x, y) : Number{0};
}

}  // namespace

template <class Number>
void fill_borders(Layers<Number>& s, const Params& params) {
    const int nx = s.grid.nx, ny = s.grid.ny;
    Field<Number>&u = s.velocity_x, &v = s.velocity_y;
    for (int y = 0; y < ny; ++y) {
        fill(s, params.borders[kWest], -1, y, 0, y, u, v);
        fill(s, params.borders[kEast], nx, y, nx - 1, y, u, v);
    }
    for (int x = 0; x < nx; ++x) {
        fill(s, params.borders[kSouth], x, -1, x, 0, v, u);
        fill(s, params.borders[kNorth], x, ny, x, ny - 1, v, u);
    }
}

template void fill_borders(Layers<float>&, const Params&);
template void fill_borders(Layers<double>&, const Params&);
}  // namespace sim
