#include "sim/bcre/face.h"
#include "sim/bcre/stages.h"
#include "sim/quanta.h"

// The paper's scheme (Strikwerda 2004), in two dimensions and as fluxes:
//
//     F = ½ (R_l v_l + R_r v_r) Δt/Δx − ¼ (R_r − R_l)        l | r
//
// which is R ← mean of four neighbours − central differences of R v. Kept as published, with its defect: a
// rolling layer at rest spreads with Δx²/4Δt along each axis. Only R is averaged; averaging h would wear down
// a pile at rest.

namespace sim::bcre {

template <class Number>
void fluxes_lax_friedrichs(const Layers<Number>& s, Scratch<Number>& scratch, Substep<Number> sub, int first,
                           int last) {
    const Number half_courant = 0.5f * (sub.dt / s.grid.dx);
    each_face(s, scratch, first, last,
              [=](Number, Number left, Number right, Number, Number v_left, Number v_right) {
                  return half_courant * (left * v_left + right * v_right) - 0.25f * (right - left);
              });
}

template void fluxes_lax_friedrichs(const Layers<float>&, Scratch<float>&, Substep<float>, int, int);
template void fluxes_lax_friedrichs(const Layers<double>&, Scratch<double>&, Substep<double>, int, int);

}  // namespace sim::bcre
