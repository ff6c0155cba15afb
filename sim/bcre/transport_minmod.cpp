#include "sim/bcre/face.h"
#include "sim/bcre/minmod.h"
#include "sim/bcre/stages.h"
#include "sim/quanta.h"

// Donor cell with the layer's depth carried to the face along its minmod-limited slope (van Leer 1979),
// second order in space where R is smooth; the transport of muscl and of bcre-inertial:
//
//     F = w Δt/Δx · (w > 0 ? R_l + ½ minmod(R_l − R_b, R_r − R_l)            b     l  |  r     y
//                          : R_r − ½ minmod(R_r − R_l, R_y − R_r))
//
// A halo vertex has no neighbour beyond: an empty one gives nothing, and at a wall w is 0.

namespace sim::bcre {
template <class Number>
void fluxes_minmod(const Layers<Number>& s, Scratch<Number>& scratch, Substep<Number> sub, int first,
                   int last) {
    const Number courant = sub.dt / s.grid.dx;
    each_face(s, scratch, first, last,
              [=](Number back, Number left, Number right, Number beyond, Number v_left, Number v_right) {
                  const Number w = face_velocity(left, v_left, right, v_right);
                  const Number across = right - left;
                  const Number from_left = left + 0.5f * minmod(left - back, across);
                  const Number from_right = right - 0.5f * minmod(across, beyond - right);
                  return courant * w * (w > 0 ? from_left : from_right);
              });
}

template void fluxes_minmod(const Layers<float>&, Scratch<float>&, Substep<float>, int, int);
template void fluxes_minmod(const Layers<double>&, Scratch<double>&, Substep<double>, int, int);

}  // namespace sim::bcre
