#pragma once

#include <cmath>

#include "sim/layers.h"
#include "sim/params.h"

// The velocity at which a layer would end on the surface as it lies now, by central differences over the
// vertex's four neighbours:
//
//            N              g_x = (E − W) / 2Δx
//            |              g_y = (N − S) / 2Δx          of z = h + R
//        W — C — E
//            |              v_eq = −(g/|g|) min(v_max, k_v |g|) R / (R + R_h)
//            S
//
// The slope of z rather than of h: it carries the lateral pressure, without which a flow digs itself into
// rills along the grid. Bedrock and layers are differenced apart: their sum would lose the layers' last
// digits.

namespace sim::bcre {

template <class Number>
struct Velocity {
    Number u, v;  // m/s
};

template <class Number>
class TerminalVelocity {
  public:
    TerminalVelocity(const Layers<Number>& layers, const Params& params)
        : s_(layers),
          per_slope_(params.speed_per_slope),
          most_(params.max_speed),
          half_(params.half_speed_depth),
          per_step_(1 / (2 * Number{layers.grid.dx})) {}

    Velocity<Number> at(int x, int y) const {
        const Number gx = rise(x - 1, y, x + 1, y) * per_step_, gy = rise(x, y - 1, x, y + 1) * per_step_;
        const Number steepness = std::sqrt(gx * gx + gy * gy), r = s_.rolling(x, y);
        const Number per_slope = per_slope_ * steepness > most_ ? most_ / steepness : per_slope_;
        const Number along = r > 0 ? -per_slope * (r / (r + half_)) : Number{0};
        return {along * gx, along * gy};
    }

  private:
    Number rise(int x0, int y0, int x1, int y1) const {
        return (s_.bedrock(x1, y1) - s_.bedrock(x0, y0)) +
               ((s_.depth(x1, y1) + s_.rolling(x1, y1)) - (s_.depth(x0, y0) + s_.rolling(x0, y0)));
    }

    const Layers<Number>& s_;
    Number per_slope_, most_, half_, per_step_;
};

}  // namespace sim::bcre
