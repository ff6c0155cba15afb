#pragma once

// The stages of a step of bcre, in call order; those of bcre-inertial are in inertial.h. Each works on the
// rows first … last-1, writes nothing else, and reads of other rows only what an earlier stage finished; so
// rows may be shared out among threads. README.md has the same as a table.

namespace sim {

struct Params;
template <class Number>
struct Layers;
template <class Number>
struct Scratch;
template <class Number>
struct Substep;

namespace bcre {

// bcre: velocity of the rolling layer down the slope of h at one speed (law C). Reads b, d, R; writes
// velocity.
template <class Number>
void slope_velocity(Layers<Number>& layers, const Params& params, int first, int last);

// Depth that a sub-step wants to carry through each face, m. Read R, velocity; write flux_x, flux_y. The
// first band writes the southern border's faces too.
template <class Number>
void fluxes_lax_friedrichs(const Layers<Number>& layers, Scratch<Number>& scratch, Substep<Number> sub,
                           int first, int last);
template <class Number>
void fluxes_local_lax_friedrichs(const Layers<Number>& layers, Scratch<Number>& scratch, Substep<Number> sub,
                                 int first, int last);
template <class Number>
void fluxes_minmod(const Layers<Number>& layers, Scratch<Number>& scratch, Substep<Number> sub, int first,
                   int last);

// How much of it each vertex can give. Reads R, fluxes; writes outflow_scale.
template <class Number>
void limit_outflow(const Layers<Number>& layers, Scratch<Number>& scratch, int first, int last);

// Fluxes as whole quanta, so that both sides of a face book the same. Reads outflow_scale; writes fluxes.
template <class Number>
void round_fluxes(const Layers<Number>& layers, Scratch<Number>& scratch, Substep<Number> sub, int first,
                  int last);

// Layers and their momentum, carried. Reads R, velocity, fluxes; writes scratch's rolling and velocity.
template <class Number>
void carry(const Layers<Number>& layers, Scratch<Number>& scratch, int first, int last);

// Slope toward the lower neighbours of h, of first and of second order. Read b, d; write slope, slope_spread.
template <class Number>
void lower_slope(const Layers<Number>& layers, Scratch<Number>& scratch, int first, int last);
template <class Number>
void limited_lower_slope(const Layers<Number>& layers, Scratch<Number>& scratch, int first, int last);

// Erosion and deposition. Read slope; write d, R, and velocity where what is eroded starts at rest.
template <class Number>
void exchange(Layers<Number>& layers, const Params& params, const Scratch<Number>& scratch,
              Substep<Number> sub, int first, int last);

// What a sub-step exchanges at the rate of this moment, m. Reads d, R, slope; writes exchanged.
template <class Number>
void exchange_at_rate(const Layers<Number>& layers, const Params& params, Scratch<Number>& scratch,
                      Substep<Number> sub, int first, int last);

// Where these rates lead, unrounded, and never stored: it only serves to find rates. Reads d, R, fluxes,
// exchanged; writes scratch's depth and rolling.
template <class Number>
void predict(const Layers<Number>& layers, Scratch<Number>& scratch, int first, int last);

// Fluxes and exchange as the means of the first ones and the present ones. The first band writes the southern
// border's faces too.
template <class Number>
void mean_rates(Scratch<Number>& scratch, int first, int last);

// Books what was found to be exchanged, in whole quanta, no more than there is. Reads exchanged; writes d, R,
// velocity.
template <class Number>
void exchange_booked(Layers<Number>& layers, const Scratch<Number>& scratch, Substep<Number> sub, int first,
                     int last);

// Starts what is too steep to lie, stops what is too thin to roll. Reads slope; writes d, R, velocity.
template <class Number>
void yield(Layers<Number>& layers, const Params& params, const Scratch<Number>& scratch, int first, int last);

}  // namespace bcre
}  // namespace sim
