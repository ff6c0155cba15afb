#include "sim/borders.h"

#include "sim/layers.h"
#include "sim/ledger.h"
#include "sim/params.h"
#include "sim/scratch.h"

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

template <class Number>
void clear_drains(Layers<Number>& s, const Outlets& outlets) {
    for (int y = 0; y < s.grid.ny; ++y)
        for (int i = outlets.first_drain[y]; i < outlets.first_drain[y + 1]; ++i) {
            const int x = outlets.drains[i];
            s.rolling(x, y) = s.velocity_x(x, y) = s.velocity_y(x, y) = 0;
        }
}

std::int64_t drained(const Scratch<float>& scratch, Model model) {
    const Directions<float>& given = scratch.given;
    const Field<float>&flux_x = scratch.flux_x, &flux_y = scratch.flux_y;
    const bool gives = model == Model::kBcre;
    const auto out_of = [&](int x, int y, Way way) {  // m
        switch (way) {
            case Way::kEast:
                return gives ? given.east(x, y) : flux_x(x, y);
            case Way::kWest:
                return gives ? given.west(x, y) : -flux_x(x - 1, y);
            case Way::kNorth:
                return gives ? given.north(x, y) : flux_y(x, y);
            case Way::kSouth:
                break;
        }
        return gives ? given.south(x, y) : -flux_y(x, y - 1);
    };
    std::int64_t quanta = 0;
    for (const auto& [x, y, way] : scratch.outlets.faces)
        quanta += static_cast<std::int64_t>(out_of(x, y, way) / kQuantum);
    return quanta;
}

template void fill_borders(Layers<float>&, const Params&);
template void fill_borders(Layers<double>&, const Params&);
template void clear_drains(Layers<float>&, const Outlets&);
template void clear_drains(Layers<double>&, const Outlets&);

}  // namespace sim
