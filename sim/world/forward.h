#pragma once

// Declarations for headers that need no definition.

namespace sim {

class Workers;
struct Params;
struct PlainContext;
struct State;
template <class Number>
struct Layers;
template <class Number>
struct Scratch;
template <class Number>
struct Substep;

}  // namespace sim
