#pragma once

// What headers speak of without knowing it.

namespace sim {

class Workers;
struct Params;
struct State;
template <class Number>
struct Layers;
template <class Number>
struct Scratch;
template <class Number>
struct Substep;

}  // namespace sim
