#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "game/base/outcome.h"
#include "game/scene/scenario.h"
#include "sim/engine.h"
#include "sim/step.h"
#include "sim/world/state.h"

namespace game {

// Gathers the commands of each tick from everything that feeds a world. They act in the order in which they are
// added: first those known beforehand, from a scene or a recording, then those that the user gives now.
class CommandSource {
  public:
    // The commands of a world that is fed from one list, sorted by tick. Valid until the next tick.
    std::span<const sim::Command> due(const sim::State& state, std::span<const TimedCommand> known);

    // The same step by step. Begins the tick of `state`, which must not change until the tick is advanced.
    void begin(const sim::State& state);
    // Adds those of this tick. `known`: sorted by tick.
    void add_known(std::span<const TimedCommand> known);
    // Adds as many as the limits of a tick leave room for.
    void add_new(std::span<const sim::Command> commands);
    // Of those added since the last call in this tick, leaves out what clashes with the world or with the others,
    // so that time goes on. Errors: the reason, worded as a notice.
    Outcome<void> leave_out_clashing();

    std::span<const sim::Command> commands() const { return commands_; }  // of this tick so far
    // Allocates here, so that ticks with fewer commands do not.
    void reserve(std::size_t commands) { commands_.reserve(commands); }

  private:
    const sim::State* state_ = nullptr;
    std::vector<sim::Command> commands_;
    std::size_t settled_ = 0;  // how many leave_out_clashing() has looked at
};

// Checks that a tick of `state` can start with these commands. Errors: a command is out of range, there are too
// many, the parameters would be inconsistent, a thing cannot be where it is wanted, or this thread rounds otherwise
// than a replay would.
Outcome<void> check_tick(const sim::State& state, std::span<const sim::Command> commands);

// Checks what can be known of commands before their ticks: each is in range, and what it builds has a place in the
// terrain of `state`. Errors: the first that will be refused whatever happens until then.
Outcome<void> check_ahead(const sim::State& state, std::span<const TimedCommand> commands);

// Checks the commands, calls `before_step`, which may record them, and runs one tick with them. Nothing else in
// the program advances a world. Errors: those of check_tick() and of `before_step`; the state is then as before.
template <class BeforeStep>
Outcome<void> advance_world(sim::State& state, std::span<const sim::Command> commands, sim::Engine& engine,
                            BeforeStep&& before_step) {
    if (auto ready = check_tick(state, commands); !ready) return ready;
    if (auto done = before_step(); !done) return done;
    sim::step(state, commands, engine);
    return {};
}
inline Outcome<void> advance_world(sim::State& state, std::span<const sim::Command> commands,
                                   sim::Engine& engine) {
    return advance_world(state, commands, engine, [] { return Outcome<void>(); });
}

}  // namespace game
