#include "sim/bcre/face.h"
#include "sim/bcre/stages.h"
#include "sim/quanta.h"

// Local Lax–Friedrichs (Rusanov 1961) with one velocity w per face, which makes it the donor cell:
//
//     F = ½ (R_l + R_r) w Δt/Δx − ½ |w| (R_r − R_l) Δt/Δx  =  w Δt/Δx · (w > 0 ? R_l : R_r)        l | r
//
// No diffusion where nothing moves.

namespace sim::bcre {

void fluxes_local_lax_friedrichs(const State& s, Scratch& scratch, Substep sub, int first, int last) {
    const float courant = sub.dt / s.grid.dx;
    each_face(s, scratch, first, last,
              [=](float, float left, float right, float, float v_left, float v_right) {
                  const float w = face_velocity(left, v_left, right, v_right);
                  return courant * w * (w > 0 ? left : right);
              });
}

}  // namespace sim::bcre
