#pragma once

#include "sim/world/command.h"
#include "sim/world/state.h"

// What commands do to the layers of one vertex, and with them to the mixture of a world of two materials and to the
// ledgers. Amounts: m, whole quanta, at least 0, at most what is there and what still fits (room_in).
namespace sim {

// What a layer can still take, m: beyond half of kDeepest it could not be counted exactly.
float room_in(float layer);

// Adds material to a layer, at rest. `of`: kUpper in a world of one material.
void pour_at(State& state, int x, int y, Layer layer, Part of, float amount);
// Takes material out of the world, of the rolling layer with its share of the momentum.
void dig_at(State& state, int x, int y, float from_rolling, float from_standing);
// Makes standing material roll, from rest.
void start_at(State& state, int x, int y, float amount);
// Brings rolling material to rest, which then is loose no more.
void settle_at(State& state, int x, int y, float amount);

}  // namespace sim
