#include <algorithm>
#include <cmath>

#include "sim/bcre/stages.h"
#include "sim/exponential.h"
#include "sim/layers.h"
#include "sim/params.h"
#include "sim/quanta.h"

// Central differences over the vertex's four neighbours:
//
//            N                 g_x = (E − W) / 2Δx
//            |                 g_y = (N − S) / 2Δx
//        W — C — E
//            |
//            S
//                              bcre-inertial:  v += (1 − e^(−Δt/τ)) (v_eq − v),  g = ∇z,  z = h + R
//                                v_eq = −(g/|g|) min(v_max, k_v |g|) R / (R + R_h)
//
// Bedrock and layers are differenced apart: their sum would lose the layers' last digits.

namespace sim::bcre {

template <class Number>
void accelerate(Layers<Number>& s, const Params& params, Substep<Number> sub, int first, int last) {
    const Number per_step = 1 / (2 * Number{s.grid.dx});
    const Number gained = 1 - exponential(-sub.dt / params.relaxation_time);
    for (int y = first; y < last; ++y) {
        const Number *b = s.bedrock.row(y), *b_n = s.bedrock.row(y + 1), *b_s = s.bedrock.row(y - 1);
        const Number *d = s.depth.row(y), *d_n = s.depth.row(y + 1), *d_s = s.depth.row(y - 1);
        const Number *r = s.rolling.row(y), *r_n = s.rolling.row(y + 1), *r_s = s.rolling.row(y - 1);
        Number *u = s.velocity_x.row(y), *v = s.velocity_y.row(y);
        for (int x = 0; x < s.grid.nx; ++x) {
            const Number gx =
                ((b[x + 1] - b[x - 1]) + ((d[x + 1] + r[x + 1]) - (d[x - 1] + r[x - 1]))) * per_step;
            const Number gy = ((b_n[x] - b_s[x]) + ((d_n[x] + r_n[x]) - (d_s[x] + r_s[x]))) * per_step;
            const Number steepness = std::sqrt(gx * gx + gy * gy);
            const Number terminal = std::min<Number>(params.max_speed, params.speed_per_slope * steepness) *
                                    (r[x] / (r[x] + params.half_speed_depth));
            const Number along = steepness > 0 ? -terminal / steepness : Number{0};
            u[x] = r[x] > 0 ? u[x] + gained * (along * gx - u[x]) : Number{0};
            v[x] = r[x] > 0 ? v[x] + gained * (along * gy - v[x]) : Number{0};
        }
    }
}

template void accelerate(Layers<float>&, const Params&, Substep<float>, int, int);
template void accelerate(Layers<double>&, const Params&, Substep<double>, int, int);

}  // namespace sim::bcre
