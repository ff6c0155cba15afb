#pragma once

#include <string>

#include "game/base/outcome.h"
#include "game/scene/scenario.h"
#include "sim/world/state.h"

namespace game {

// The world of `initial` as it stands in `state`, as the start of another one: layers, parameters, forest with the stems
// that lie, earth, and objects that stand. What moves starts from rest, the standing layer is natural ground, and the
// ledger is that of a start. An object that was destroyed is cleared away with its rubble: a lift as a whole, a row of nets
// piece by piece. One that was damaged or buried is whole again. Goal, running commands and those of the scene stay behind.
// Errors: a flow demo, a layer that is deeper than a start may have, or an object that cannot be placed again (status 2).
Outcome<Scenario> scenario_of_now(const Scenario& initial, const sim::State& state);

// What scenario_of_now() does not keep of a state, as sentences for a notice; empty if it keeps all.
std::string not_kept(const sim::State& state);

// The text of a recording in which nothing is done: a world to play in.
std::string recording_of(const Scenario& scenario);

}  // namespace game
