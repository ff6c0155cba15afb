#pragma once

// The stages of a step, in call order. Each works on the rows first … last-1, writes nothing else, and reads
// of other rows only what an earlier stage finished; so rows may be shared out among threads. README.md has
// the same as a table.

namespace sim {

struct Params;
struct Scratch;
struct State;
struct Substep;

namespace bcre {

// bcre: velocity of the rolling layer down the slope of h at one speed (law C). Reads b, d, R; writes
// velocity.
void slope_velocity(State& state, const Params& params, int first, int last);

// bcre-inertial: velocity relaxes toward the terminal one of surface and depth. Reads b, d, R; writes
// velocity.
void accelerate(State& state, const Params& params, Substep sub, int first, int last);

// Depth that a sub-step wants to carry through each face, m. Read R, velocity; write flux_x, flux_y. The
// first band writes the southern border's faces too.
void fluxes_lax_friedrichs(const State& state, Scratch& scratch, Substep sub, int first, int last);
void fluxes_local_lax_friedrichs(const State& state, Scratch& scratch, Substep sub, int first, int last);
void fluxes_minmod(const State& state, Scratch& scratch, Substep sub, int first, int last);

// How much of it each vertex can give. Reads R, fluxes; writes outflow_scale.
void limit_outflow(const State& state, Scratch& scratch, int first, int last);

// Fluxes as whole quanta, so that both sides of a face book the same. Reads outflow_scale; writes fluxes.
void round_fluxes(const State& state, Scratch& scratch, Substep sub, int first, int last);

// Layers and their momentum, carried. Reads R, velocity, fluxes; writes scratch's rolling and velocity.
void carry(const State& state, Scratch& scratch, int first, int last);

// Slope toward the lower neighbours of h. Reads b, d; writes slope, slope_spread.
void lower_slope(const State& state, Scratch& scratch, int first, int last);

// Erosion and deposition. Read slope; write d, R, and velocity where what is eroded starts at rest.
void exchange(State& state, const Params& params, const Scratch& scratch, Substep sub, int first, int last);
void exchange_inertial(State& state, const Params& params, const Scratch& scratch, Substep sub, int first,
                       int last);

// Starts what is too steep to lie, stops what is too thin to roll. Reads slope, first_slope; writes d, R,
// velocity.
void yield(State& state, const Params& params, const Scratch& scratch, int first, int last);

}  // namespace bcre
}  // namespace sim
