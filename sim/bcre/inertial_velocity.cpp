#include "sim/bcre/inertial.h"
#include "sim/bcre/inertial_terminal.h"
#include "sim/exponential.h"
#include "sim/layers.h"
#include "sim/params.h"
#include "sim/quanta.h"

// v += (1 − e^(−Δt/2τ)) (v_eq − v), v_eq by inertial_terminal.h. It leaves b, d and R as they are, so v_eq
// stands while it lasts and the exponential is its exact answer, however short τ. Half of it before transport
// and exchange and half after (inertial_finish) make the sub-step second order (Strang 1968).

namespace sim::bcre {

template <class Number>
void inertial_relax(Layers<Number>& s, const Params& params, Substep<Number> sub, int first, int last) {
    const TerminalVelocity<Number> terminal(s, params);
    const Number gained = 1 - exponential(Number{-0.5f} * sub.dt / params.relaxation_time);
    for (int y = first; y < last; ++y) {
        const Number* r = s.rolling.row(y);
        Number *u = s.velocity_x.row(y), *v = s.velocity_y.row(y);
        for (int x = 0; x < s.grid.nx; ++x) {
            const Velocity<Number> end = terminal.at(x, y);
            u[x] = r[x] > 0 ? u[x] + gained * (end.u - u[x]) : Number{0};
            v[x] = r[x] > 0 ? v[x] + gained * (end.v - v[x]) : Number{0};
        }
    }
}

template void inertial_relax(Layers<float>&, const Params&, Substep<float>, int, int);
template void inertial_relax(Layers<double>&, const Params&, Substep<double>, int, int);

}  // namespace sim::bcre
