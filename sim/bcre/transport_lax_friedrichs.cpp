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

void fluxes_lax_friedrichs(const State& s, Scratch& scratch, Substep sub, int first, int last) {
    const float half_courant = 0.5f * (sub.dt / s.grid.dx);
    each_face(s, scratch, first, last,
              [=](float, float left, float right, float, float v_left, float v_right) {
                  return half_courant * (left * v_left + right * v_right) - 0.25f * (right - left);
              });
}

}  // namespace sim::bcre
