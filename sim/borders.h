#pragma once

#include <cstdint>

namespace sim {

enum class Model;
struct Outlets;
struct Params;
template <class Number>
struct Layers;
template <class Number>
struct Scratch;

// Sets the halo of depth, rolling and velocity for the next stages. Bedrock's halo never changes: it carries
// the slope on, or mirrors it at a wall.
//   wall   layers and velocity are mirrored: the flow across is zero, and so is the slope
//   open   the standing layer goes on: material leaves over ground that looks like the last cell
//   sink   the world ends in bare bedrock: the edge is a ledge, from which loose material falls
template <class Number>
void fill_borders(Layers<Number>& layers, const Params& params);

// Takes away what the last transport carried into no-data. Writes rolling and velocity on drains.
template <class Number>
void clear_drains(Layers<Number>& layers, const Outlets& outlets);

// What the last transport carried into drains (halo or no-data), in whole quanta.
std::int64_t drained(const Scratch<float>& scratch, Model model);

}  // namespace sim
