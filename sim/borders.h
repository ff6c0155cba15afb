#pragma once

namespace sim {

struct Params;
struct Scratch;
struct State;

// Sets the halo of depth, rolling and velocity for the next stages. Bedrock's halo never changes: it carries
// the slope on, or mirrors it at a wall.
//   wall   layers and velocity are mirrored: the flow across is zero, and so is the slope
//   open   the standing layer goes on: material leaves over ground that looks like the last cell
//   sink   the world ends in bare bedrock: the edge is a ledge, from which loose material falls
void fill_borders(State& state, const Params& params);

// Books what the last transport carried into drains (halo or no-data), in whole quanta, and takes it away.
// Reads the fluxes of `scratch`; writes rolling and velocity on drains, ledger.out.
void drain(State& state, const Scratch& scratch);

}  // namespace sim
