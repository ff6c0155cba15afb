#include <algorithm>
#include <cmath>

#include "sim/bcre/stages.h"
#include "sim/layers.h"
#include "sim/params.h"

// Central differences over the vertex's four neighbours:
//
//            N                 g_x = (E − W) / 2Δx
//            |                 g_y = (N − S) / 2Δx
//        W — C — E
//            |                 bcre:           v = −(g/|g|) V,           g = ∇h,  h = b + d
//            S                   (C)  V = v₀                             one speed
//                                (HK) V = min(v_max, k_v |g|)            Hadeler and Kuttler 1999
//                                (T)  V = min(v_max, v₀ + ½ γ̇ R)         a layer sheared at the rate γ̇; its
//                                mean speed
//
// Bedrock and layers are differenced apart: their sum would lose the layers' last digits.

namespace sim::bcre {

template <class Number>
void slope_velocity(Layers<Number>& s, const Params& params, int first, int last) {
    const Number per_step = 1 / (2 * Number{s.grid.dx});
    const auto speed = [&](Number steepness, Number depth) -> Number {
        switch (params.law) {
            case Law::kConstant:
                return params.rolling_speed;
            case Law::kSlope:
                return std::min<Number>(params.max_speed, params.speed_per_slope * steepness);
            case Law::kShear:
                return std::min<Number>(params.max_speed,
                                        params.rolling_speed + Number{0.5} * params.shear_rate * depth);
        }
        return 0;
    };
    for (int y = first; y < last; ++y) {
        const Number *b = s.bedrock.row(y), *b_n = s.bedrock.row(y + 1), *b_s = s.bedrock.row(y - 1);
        const Number *d = s.depth.row(y), *d_n = s.depth.row(y + 1), *d_s = s.depth.row(y - 1);
        const Number* rolling = s.rolling.row(y);
        Number *u = s.velocity_x.row(y), *v = s.velocity_y.row(y);
        for (int x = 0; x < s.grid.nx; ++x) {
            const Number gx = ((b[x + 1] - b[x - 1]) + (d[x + 1] - d[x - 1])) * per_step;
            const Number gy = ((b_n[x] - b_s[x]) + (d_n[x] - d_s[x])) * per_step;
            const Number steepness = std::sqrt(gx * gx + gy * gy);
            const Number along =
                rolling[x] > 0 && steepness > 0 ? -speed(steepness, rolling[x]) / steepness : Number{0};
            u[x] = along * gx;
            v[x] = along * gy;
        }
    }
}

template void slope_velocity(Layers<float>&, const Params&, int, int);
template void slope_velocity(Layers<double>&, const Params&, int, int);

}  // namespace sim::bcre
