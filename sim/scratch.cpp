#include "sim/scratch.h"

namespace sim {

template <class Number>
Scratch<Number>::Scratch(const Layers<Number>& s) {
    flux_x = flux_y = outflow_scale = rolling = velocity_x = velocity_y = slope = slope_spread = exchanged =
        momentum_x.u = momentum_x.v = momentum_y.u = momentum_y.v = depth = first_flux_x = first_flux_y =
            first_exchanged = Field<Number>(s.grid);

    const int nx = s.grid.nx, ny = s.grid.ny;
    const auto is = [&](int x, int y, Site site) { return s.site(x, y) == site; };
    for (int y = 0; y < ny; ++y)
        for (int x = -1; x < nx; ++x) {
            if (is(x, y, Site::kGround) && is(x + 1, y, Site::kDrain))
                drain_faces.push_back({x, y, true, +1});
            if (is(x, y, Site::kDrain) && is(x + 1, y, Site::kGround))
                drain_faces.push_back({x, y, true, -1});
        }
    for (int y = -1; y < ny; ++y)
        for (int x = 0; x < nx; ++x) {
            if (is(x, y, Site::kGround) && is(x, y + 1, Site::kDrain))
                drain_faces.push_back({x, y, false, +1});
            if (is(x, y, Site::kDrain) && is(x, y + 1, Site::kGround))
                drain_faces.push_back({x, y, false, -1});
        }
    for (int y = 0; y < ny; ++y)
        for (int x = 0; x < nx; ++x)
            if (is(x, y, Site::kDrain) && (is(x - 1, y, Site::kGround) || is(x + 1, y, Site::kGround) ||
                                           is(x, y - 1, Site::kGround) || is(x, y + 1, Site::kGround)))
                drain_vertices.emplace_back(x, y);
}

template struct Scratch<float>;
template struct Scratch<double>;

}  // namespace sim
