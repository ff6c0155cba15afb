#pragma once

#include <string>
#include <vector>

#include "sim/core/grid.h"

namespace sim {

struct State;
template <class Number>
struct Scratch;

struct NamedField {
    std::string name;  // as the member is called: "rolling", "u1.flux_x"
    const Field<float>* values;
};

// What of a state moves, in the order of its hash, and first_depth; water in a world with things; what weather has.
std::vector<NamedField> fields_of(const State& state);
// What the stages of a plain step leave for the next ones, as far as this world uses them.
std::vector<NamedField> fields_of(const Scratch<float>& scratch);

}  // namespace sim
