#pragma once

// The stages of bcre-inertial, in call order; with the rules of plain.h. A sub-step is a half of relaxation,
// transport and exchange by Heun's method, and the other half of relaxation (inertial_heun.cpp).

namespace sim {

struct Params;
template <class T>
class Field;
template <class Number>
struct Layers;
template <class Number>
struct Scratch;
template <class Number>
struct Substep;

namespace bcre {

// Half of a sub-step's relaxation toward the terminal velocity. Reads b, d, R; writes velocity.
template <class Number>
void inertial_relax(Layers<Number>& layers, const Params& params, Substep<Number> sub, int first, int last);

// What a sub-step exchanges at the rate of this moment, m, erosion positive. Reads b, d, R, velocity; writes
// exchanged, and slope and slope_spread for inertial_yield.
template <class Number>
void inertial_exchange(const Layers<Number>& layers, const Params& params, Scratch<Number>& scratch,
                       Substep<Number> sub, int first, int last);

// What a sub-step carries through each face at the rate of this moment, layer and momentum. `begun` is R at
// the sub-step's beginning: what was thinner than can be rounded then gives nothing. Reads R, velocity;
// writes flux_x, flux_y, momentum_x, momentum_y. The first band writes the southern border's faces too.
template <class Number>
void inertial_fluxes(const Layers<Number>& layers, const Field<Number>& begun, Scratch<Number>& scratch,
                     Substep<Number> sub, int first, int last);

// Where these rates lead, unrounded, and never stored: it only serves to find rates. Reads the layers,
// fluxes, momentum, exchanged; writes exchanged (no more than there is after transport) and scratch's layers.
template <class Number>
void inertial_predict(const Layers<Number>& layers, Scratch<Number>& scratch, int first, int last);

// The means of the first fluxes and the present ones in whole quanta, so that both sides of a face book the
// same. Reads first_flux, flux; writes first_flux. The first band writes the southern border's faces too.
template <class Number>
void inertial_book(Scratch<Number>& scratch, Substep<Number> sub, int first, int last);

// The end of the sub-step: scratch's layers, which began it, become the mean of themselves and of where the
// predicted ones lead; and the other half of relaxation. Reads the predicted layers and all of scratch;
// writes scratch's layers.
template <class Number>
void inertial_finish(const Layers<Number>& predicted, const Params& params, Scratch<Number>& scratch,
                     Substep<Number> sub, int first, int last);

// Starts what is too steep to lie, stops what is too thin to roll. Reads slope, slope_spread, first_slope,
// first_depth; writes d, R, velocity.
template <class Number>
void inertial_yield(Layers<Number>& layers, const Params& params, const Scratch<Number>& scratch, int first,
                    int last);

}  // namespace bcre
}  // namespace sim
