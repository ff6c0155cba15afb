#pragma once

namespace sim {

struct Params;
template <class Number>
struct Layers;

// Sets the halo of depth, rolling and velocity for the next stages. Bedrock's halo never changes: it carries
// the slope on, or mirrors it at a wall.
//   wall   layers and velocity are mirrored: the flow across is zero, and so is the slope
//   open   the standing layer goes on: material leaves over ground that looks like the last cell
//   sink   the world ends in bare bedrock: the edge is a ledge, from which loose material falls
template <class Number>
void fill_borders(Layers<Number>& layers, const Params& params);

}  // namespace sim
