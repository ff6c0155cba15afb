#include <algorithm>

#include "sim/bcre/stages.h"
#include "sim/layers.h"
#include "sim/scratch.h"

// Second order in time (SSP-RK2; Gottlieb, Shu and Tadmor 2001), with L what transport and exchange do in a
// sub-step:
//
//     u₁ = u₀ + L(u₀)        u = u₀ + ½ (L(u₀) + L(u₁))
//
// As a mean of forward sub-steps it keeps what each of them keeps. What is transferred is a flux or an
// exchange in both halves, so the mean of them is too: mass is booked once, at the end, in whole quanta. u₁
// only serves to find L(u₁).

namespace sim::bcre {

template <class Number>
void predict(const Layers<Number>& s, Scratch<Number>& scratch, int first, int last) {
    for (int y = first; y < last; ++y) {
        const Number *fx = scratch.flux_x.row(y), *fn = scratch.flux_y.row(y),
                     *fs = scratch.flux_y.row(y - 1);
        const Number *r = s.rolling.row(y), *d = s.depth.row(y), *exchanged = scratch.exchanged.row(y);
        Number *rolling = scratch.rolling.row(y), *depth = scratch.depth.row(y);
        for (int x = 0; x < s.grid.nx; ++x) {
            const Number leaves = (fx[x] - fx[x - 1]) + (fn[x] - fs[x]);
            rolling[x] = std::max(Number{0}, (r[x] - leaves) + exchanged[x]);
            depth[x] = d[x] - exchanged[x];
        }
    }
}

template <class Number>
void mean_rates(Scratch<Number>& scratch, int first, int last) {
    const int nx = scratch.flux_x.nx();
    const auto mean = [nx](const Field<Number>& of, Field<Number>& into, int y, int from) {
        const Number* one = of.row(y);
        Number* other = into.row(y);
        for (int x = from; x < nx; ++x) other[x] = Number{0.5} * (one[x] + other[x]);
    };
    for (int y = first == 0 ? -1 : first; y < last; ++y) mean(scratch.first_flux_y, scratch.flux_y, y, 0);
    for (int y = first; y < last; ++y) {
        mean(scratch.first_flux_x, scratch.flux_x, y, -1);
        mean(scratch.first_exchanged, scratch.exchanged, y, 0);
    }
}

template void predict(const Layers<float>&, Scratch<float>&, int, int);
template void predict(const Layers<double>&, Scratch<double>&, int, int);
template void mean_rates(Scratch<float>&, int, int);
template void mean_rates(Scratch<double>&, int, int);

}  // namespace sim::bcre
