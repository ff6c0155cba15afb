#pragma once

#include <cstdint>
#include <span>

#include "sim/core/grid.h"
#include "sim/world/ledger.h"
#include "sim/world/params.h"

// Two materials in one world, of which the lower one lies under the upper: snow over soil, say. What rolls is
// a mixture of both, and so is what it leaves:
//
//     R                  rolling layer; `rolling` of it is the lower material
//     d    above         the first cover and what came to rest; `settled` of it is the lower material
//          untouched     the lower material alone, as it lay from the first
//     b                  bedrock
//
// A layer is well mixed: what is taken from it is mixed as it is. What is eroded comes from above, and from
// the untouched when nothing is left above it. How much of both layers moves, and whither, the step of either
// model says; the mixture goes along with it, exactly: every amount here is whole quanta, none is below 0 or
// above its layer, and what there is of the lower material is accounted for as all mass is.
//
// The mixture determines the parameters of a vertex: those of both materials, blended in proportion
// (blend.h). A layer flows with the parameters of the rolling mixture. It erodes, deposits, starts and
// freezes with the mean of the rolling and the standing mixture, because there one rubs on the other.

namespace sim {

class Workers;
struct Outlets;
struct State;
struct View;

struct Mixture {
    Params lower;  // the lower material's numbers; State::params are the upper one's
    Field<float> rolling, settled, untouched;  // m of the lower material
    Ledger ledger;                             // of it alone
};

// What lies at the surface is what lies in the uppermost of it. m
inline constexpr float kSkin = 0.05f;

// Shares of the lower material, 0 to 1, at a vertex: in what rolls, and at the surface of what lies; 0 where
// there is nothing.
float share_in_rolling(const View& world, int x, int y);
float share_at_surface(const View& world, int x, int y);

// The lower material has its own numbers, but model, scheme, law, borders, tick and Courant number are the
// world's.
void take_choices(const Params& world, Params& lower);

// What a world begins with: `depth` m of the lower material, grid.size() values, row-major, as far as there
// is so much to erode; all else is the upper one. `state` has its layers.
Mixture make_mixture(const State& state, const Params& lower, std::span<const float> depth);

// A vertex's mixture follows what a command does to its layers; for worlds of one material, nothing. To be
// called while R and d are what they were, m in whole quanta.
void pour_lower(State& state, int x, int y, bool rolling, float amount);
void dig_mixture(State& state, int x, int y, float from_rolling, float from_standing);
void start_mixture(State& state, int x, int y, float amount);
void stop_mixture(State& state, int x, int y, float amount);

// The extra working memory for a sub-step of a mixed world. Made once per world.
struct Mixing {
    Mixing(const State& state);

    Field<std::uint8_t> flow, bed;  // which blend each vertex goes by, 0 to kBlends - 1
    Field<float> depth, rolling;    // m, as the sub-step found them
    Field<float> lower_x, lower_y;  // m of the lower material through each face, to the east, to the north
};

// Finds the blends and stores the layers, before a sub-step.
void begin_mixing(const State& state, Mixing& mixing, Workers& workers);
// After it: the mixture goes along with what went through the faces (m, whole quanta), and with what was
// exchanged. `dither`, 0 to 1, as the sub-step rounded.
void finish_mixing(State& state, Mixing& mixing, const Field<float>& flux_x, const Field<float>& flux_y,
                   const Outlets& outlets, float dither, Workers& workers);

}  // namespace sim
