#include <algorithm>

#include "sim/bcre/inertial.h"
#include "sim/bcre/limiter.h"
#include "sim/layers.h"
#include "sim/quanta.h"
#include "sim/scratch.h"

// Layer and momentum through a face, second order where they are smooth:
//
//     back   left | right   beyond        q_l = q_left + ½ σ_left,  q_r = q_right − ½ σ_right   for q = R, u,
//     v x-1     x   |  x+1     x+2          σ the limited slope of a vertex (limiter.h)
//
//     w = (R_l v_l + R_r v_r) / (R_l + R_r)     the joint velocity across the face
//     w > 0:  F = min(R_l w Δt/Δx, ¼ R_left),    momentum F (u_l, v_l)
//     w < 0:  the mirror image
//
// One velocity of the material on both sides together: if each vertex gave by its own (as in flux-vector
// splitting), streams that meet in a gully would pass through each other, and a real avalanche spread over
// three times its ground. Through each of four faces goes a quarter of a vertex at most, which no flow asks
// for at a Courant number below a quarter: so none gives more than it has.
//
// What began the sub-step with ten quanta or less gives nothing; so neither does what was empty. The mean of
// two stages leaves a vertex at least half of what it began with, and rounding four faces and the exchange
// takes less than a quantum each. Walls let nothing pass.

namespace sim::bcre {
namespace {

// A vertex's value as it is at its face toward `ahead`, and toward `back`.
template <class Number>
Number forward(Number back, Number here, Number ahead) {
    return here + Number{0.5f} * monotonized(here - back, ahead - here);
}
template <class Number>
Number backward(Number back, Number here, Number ahead) {
    return here - Number{0.5f} * monotonized(here - back, ahead - here);
}

// The four vertices of a row of faces, for one field.
template <class Number>
struct Stencil {
    const Number *back, *left, *right, *beyond;
    Number at_left(int x) const { return forward(back[x], left[x], right[x]); }
    Number at_right(int x) const { return backward(left[x], right[x], beyond[x]); }
};

template <class Number>
struct FaceRow {
    Stencil<Number> rolling, u, v;
    const Number *begun_left, *begun_right;
    const Site *site_left, *site_right;
    Number *flux, *momentum_u, *momentum_v;

    // `along_x`: of faces between west and east, which u goes through; else v does.
    template <bool along_x>
    void carry(int x, Number courant) const {
        constexpr Number kThin = 10 * kGrain<Number>, kMost = 0.25f;
        // Rounding may leave a face of nothing a hair below it, and w no mean any more.
        const Number r_l = std::max(rolling.at_left(x), Number{0});
        const Number r_r = std::max(rolling.at_right(x), Number{0}), both = r_l + r_r;
        const Number u_l = u.at_left(x), u_r = u.at_right(x), v_l = v.at_left(x), v_r = v.at_right(x);
        const Number momentum = along_x ? r_l * u_l + r_r * u_r : r_l * v_l + r_r * v_r;
        const Number w = both > 0 ? momentum / both : Number{0};
        const bool wall = site_left[x] == Site::kWall || site_right[x] == Site::kWall;
        const Number from_left = begun_left[x] > kThin ? kMost * rolling.left[x] : Number{0};
        const Number from_right = begun_right[x] > kThin ? kMost * rolling.right[x] : Number{0};
        const Number toward = std::min(courant * r_l * std::max(w, Number{0}), from_left);
        const Number away = std::min(courant * r_r * std::max(-w, Number{0}), from_right);
        const Number f = wall ? Number{0} : toward - away;
        flux[x] = f;
        momentum_u[x] = f * (f > 0 ? u_l : u_r);
        momentum_v[x] = f * (f > 0 ? v_l : v_r);
    }
};

}  // namespace

template <class Number>
void inertial_fluxes(const Layers<Number>& s, const Field<Number>& begun, Scratch<Number>& scratch,
                     Substep<Number> sub, int first, int last) {
    const int nx = s.grid.nx, ny = s.grid.ny;
    const Number courant = sub.dt / s.grid.dx;
    for (int y = first; y < last; ++y) {
        // Beyond the halo nothing is known: its vertex stands in for what would lie there.
        const auto along_x = [y](const Field<Number>& f, int back, int beyond) {
            const Number* row = f.row(y);
            return Stencil<Number>{row + back, row, row + 1, row + beyond};
        };
        const auto faces = [&](int from, int to, int back, int beyond) {
            const FaceRow<Number> row{along_x(s.rolling, back, beyond),
                                      along_x(s.velocity_x, back, beyond),
                                      along_x(s.velocity_y, back, beyond),
                                      begun.row(y),
                                      begun.row(y) + 1,
                                      s.site.row(y),
                                      s.site.row(y) + 1,
                                      scratch.flux_x.row(y),
                                      scratch.momentum_x.u.row(y),
                                      scratch.momentum_x.v.row(y)};
            for (int x = from; x < to; ++x) row.template carry<true>(x, courant);
        };
        faces(-1, 0, 0, 2);
        faces(0, nx - 1, -1, 2);
        faces(nx - 1, nx, -1, 1);
    }
    for (int y = first == 0 ? -1 : first; y < last; ++y) {
        const auto along_y = [&](const Field<Number>& f) {
            return Stencil<Number>{f.row(std::max(y - 1, -1)), f.row(y), f.row(y + 1),
                                   f.row(std::min(y + 2, ny))};
        };
        const FaceRow<Number> row{along_y(s.rolling),
                                  along_y(s.velocity_x),
                                  along_y(s.velocity_y),
                                  begun.row(y),
                                  begun.row(y + 1),
                                  s.site.row(y),
                                  s.site.row(y + 1),
                                  scratch.flux_y.row(y),
                                  scratch.momentum_y.u.row(y),
                                  scratch.momentum_y.v.row(y)};
        for (int x = 0; x < nx; ++x) row.template carry<false>(x, courant);
    }
}

template void inertial_fluxes(const Layers<float>&, const Field<float>&, Scratch<float>&, Substep<float>, int,
                              int);
template void inertial_fluxes(const Layers<double>&, const Field<double>&, Scratch<double>&, Substep<double>,
                              int, int);

}  // namespace sim::bcre
