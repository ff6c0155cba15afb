#include "sim/bcre/face.h"
#include "sim/bcre/stages.h"
#include "sim/quanta.h"

// Local Lax–Friedrichs (Rusanov 1961) with one velocity w per face, which makes it the donor cell:
//
//     F = ½ (R_l + R_r) w Δt/Δx − ½ |w| (R_r − R_l) Δt/Δx  =  w Δt/Δx · (w > 0 ? R_l : R_r)        l | r
//
// No diffusion where nothing moves.

namespace sim::bcre {

template <class Number>
void fluxes_local_lax_friedrichs(const Layers<Number>& s, Scratch<Number>& scratch, Substep<Number> sub,
                                 int first, int last) {
    const Number courant = sub.dt / s.grid.dx;
    each_face(s, scratch, first, last,
              [=](Number, Number left, Number right, Number, Number v_left, Number v_right) {
                  const Number w = face_velocity(left, v_left, right, v_right);
                  return courant * w * (w > 0 ? left : right);
              });
}

template void fluxes_local_lax_friedrichs(const Layers<float>&, Scratch<float>&, Substep<float>, int, int);
template void fluxes_local_lax_friedrichs(const Layers<double>&, Scratch<double>&, Substep<double>, int, int);

}  // namespace sim::bcre
