#include "sim/bcre/face.h"
#include "sim/bcre/stages.h"
#include "sim/quanta.h"

// Donor cell with the layer's depth carried to the face along its minmod-limited slope (van Leer 1979),
// second order in space where R is smooth; the transport of bcre-inertial:
//
//     F = w Δt/Δx · (w > 0 ? R_l + ½ minmod(R_l − R_b, R_r − R_l)            b     l  |  r     y
//                          : R_r − ½ minmod(R_r − R_l, R_y − R_r))
//
// A halo vertex has no neighbour beyond: an empty one gives nothing, and at a wall w is 0.

namespace sim::bcre {
namespace {

float minmod(float a, float b) {
    const float smaller = std::fabs(a) < std::fabs(b) ? a : b;
    return a * b > 0 ? smaller : 0.f;
}

}  // namespace

void fluxes_minmod(const State& s, Scratch& scratch, Substep sub, int first, int last) {
    const float courant = sub.dt / s.grid.dx;
    each_face(s, scratch, first, last,
              [=](float back, float left, float right, float beyond, float v_left, float v_right) {
                  const float w = face_velocity(left, v_left, right, v_right);
                  const float across = right - left;
                  const float from_left = left + 0.5f * minmod(left - back, across);
                  const float from_right = right - 0.5f * minmod(across, beyond - right);
                  return courant * w * (w > 0 ? from_left : from_right);
              });
}

}  // namespace sim::bcre
