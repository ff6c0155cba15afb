#pragma once

#include <cstdint>
#include <span>

#include "sim/core/grid.h"
#include "sim/world/ledger.h"
#include "sim/world/params.h"

// Two materials in one world, one under the other, such as snow on soil. The rolling layer is a mixture of
// both, and so is its deposit:
//
//     R                  rolling layer; `rolling` of it is the lower material
//     d    above         the initial cover and deposits; `settled` of it is the lower material
//          untouched     the lower material alone, never moved
//     b                  bedrock
//
// A layer is well mixed: material taken from it has the composition of the layer. Erosion takes `above`
// first, then `untouched`. The model computes the amounts that move, and the mixture follows exactly. Every
// amount here is in whole quanta, at least 0 and at most its layer. The lower material has a mass ledger of
// its own.
//
// The mixture determines the parameters of a vertex: those of both materials, blended in proportion
// (blend.h). A layer flows with the parameters of the rolling mixture. It erodes, deposits, starts and
// freezes with the mean of the rolling and the standing mixture, because one layer rubs on the other.

namespace sim {

class Workers;
struct Outlets;
struct State;
struct View;

struct Mixture {
    Params lower;  // parameters of the lower material; State::params are those of the upper one
    Field<float> rolling, settled, untouched;  // m of the lower material
    Ledger ledger;                             // of the lower material
};

// Depth of ground that counts as its surface, m.
inline constexpr float kSkin = 0.05f;

// Shares of the lower material at a vertex, 0 to 1: in the rolling layer, and at the surface of the standing
// layer. 0 for an empty layer.
float share_in_rolling(const View& world, int x, int y);
float share_at_surface(const View& world, int x, int y);

// Copies model, scheme, law, borders, tick and Courant number of the world to the lower material. Its other
// parameters are its own.
void take_choices(const Params& world, Params& lower);

// How much of the lower material there is, m, grid.size() values each, row-major. The rest is the upper material.
struct LowerAmounts {
    std::span<const float> untouched;     // cut off at the standing depth
    std::span<const float> settled = {};  // cut off at what stands above; none: 0
    std::span<const float> rolling = {};  // cut off at the rolling layer; none: 0
};
// Makes the mixture of an initial state, which must have its layers.
Mixture make_mixture(const State& state, const Params& lower, const LowerAmounts& amounts);

// What edit_layers.h does to the mixture of a vertex, before R and d change; the last three do nothing in a world of one
// material. Amounts: m, whole quanta.
void pour_lower(State& state, int x, int y, bool rolling, float amount);
void dig_mixture(State& state, int x, int y, float from_rolling, float from_standing);
void start_mixture(State& state, int x, int y, float amount);
void stop_mixture(State& state, int x, int y, float amount);

// Working memory for a sub-step of a world of two materials. Made once per world.
struct Mixing {
    Mixing(const State& state);

    Field<std::uint8_t> flow, bed;  // blend of each vertex, 0 to kBlends - 1
    Field<float> depth, rolling;    // m, before the sub-step
    Field<float> lower_x, lower_y;  // m of the lower material through each face, eastward and northward
};

// Finds the blends and stores the layers. Call before a sub-step.
void begin_mixing(const State& state, Mixing& mixing, Workers& workers);
// Moves the lower material with an exchange that comes before the fluxes, m in whole quanta, erosion positive.
void mix_exchange(State& state, Mixing& mixing, const Field<float>& exchanged, float dither,
                  Workers& workers);
// Moves the lower material with the fluxes through the faces (m, whole quanta) and with the exchange. Call
// after a sub-step. `dither`: that of the sub-step, 0 to 1.
void finish_mixing(State& state, Mixing& mixing, const Field<float>& flux_x, const Field<float>& flux_y,
                   const Outlets& outlets, float dither, Workers& workers);

}  // namespace sim
