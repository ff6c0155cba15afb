#include <algorithm>
#include <cmath>

#include "sim/bcre/stages.h"
#include "sim/exponential.h"
#include "sim/params.h"
#include "sim/quanta.h"
#include "sim/state.h"

// Central differences over the vertex's four neighbours:
//
//            N                 g_x = (E − W) / 2Δx
//            |                 g_y = (N − S) / 2Δx
//        W — C — E
//            |                 bcre:           v = −V g/|g|,           g = ∇h,  h = b + d
//            S                 bcre-inertial:  v += (1 − e^(−Δt/τ)) (v_eq − v),  g = ∇z,  z = h + R
//                              v_eq = −(g/|g|) min(v_max, k_v |g|) R / (R + R_h)
//
// Bedrock and layers are differenced apart: their sum would lose the layers' last digits.

namespace sim::bcre {

void slope_velocity(State& s, const Params& params, int first, int last) {
    const float per_step = 1.f / (2.f * s.grid.dx), speed = params.rolling_speed;
    for (int y = first; y < last; ++y) {
        const float *b = s.bedrock.row(y), *b_n = s.bedrock.row(y + 1), *b_s = s.bedrock.row(y - 1);
        const float *d = s.depth.row(y), *d_n = s.depth.row(y + 1), *d_s = s.depth.row(y - 1);
        const float* rolling = s.rolling.row(y);
        float *u = s.velocity_x.row(y), *v = s.velocity_y.row(y);
        for (int x = 0; x < s.grid.nx; ++x) {
            const float gx = ((b[x + 1] - b[x - 1]) + (d[x + 1] - d[x - 1])) * per_step;
            const float gy = ((b_n[x] - b_s[x]) + (d_n[x] - d_s[x])) * per_step;
            const float steepness = std::sqrt(gx * gx + gy * gy);
            const float along = rolling[x] > 0 && steepness > 0 ? -speed / steepness : 0.f;
            u[x] = along * gx;
            v[x] = along * gy;
        }
    }
}

void accelerate(State& s, const Params& params, Substep sub, int first, int last) {
    const float per_step = 1.f / (2.f * s.grid.dx);
    const float gained = 1.f - exponential(-sub.dt / params.relaxation_time);
    for (int y = first; y < last; ++y) {
        const float *b = s.bedrock.row(y), *b_n = s.bedrock.row(y + 1), *b_s = s.bedrock.row(y - 1);
        const float *d = s.depth.row(y), *d_n = s.depth.row(y + 1), *d_s = s.depth.row(y - 1);
        const float *r = s.rolling.row(y), *r_n = s.rolling.row(y + 1), *r_s = s.rolling.row(y - 1);
        float *u = s.velocity_x.row(y), *v = s.velocity_y.row(y);
        for (int x = 0; x < s.grid.nx; ++x) {
            const float gx =
                ((b[x + 1] - b[x - 1]) + ((d[x + 1] + r[x + 1]) - (d[x - 1] + r[x - 1]))) * per_step;
            const float gy = ((b_n[x] - b_s[x]) + ((d_n[x] + r_n[x]) - (d_s[x] + r_s[x]))) * per_step;
            const float steepness = std::sqrt(gx * gx + gy * gy);
            const float terminal = std::min(params.max_speed, params.speed_per_slope * steepness) *
                                   (r[x] / (r[x] + params.half_speed_depth));
            const float along = steepness > 0 ? -terminal / steepness : 0.f;
            u[x] = r[x] > 0 ? u[x] + gained * (along * gx - u[x]) : 0.f;
            v[x] = r[x] > 0 ? v[x] + gained * (along * gy - v[x]) : 0.f;
        }
    }
}

}  // namespace sim::bcre
