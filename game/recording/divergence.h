#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "game/base/outcome.h"
#include "game/recording/command_source.h"
#include "game/scene/scenario.h"
#include "sim/engine.h"
#include "sim/world/snapshot.h"
#include "sim/world/state.h"

namespace game {

// One of two runs that are compared bit by bit.
struct Side {
    // May change the state it is given, so that tests can plant a fault. `scratch` is null after a swept
    // tick, whose `stage` is "sweep".
    struct Moment {
        std::int64_t tick;
        int substep, number;  // as in sim::StageWatch
        std::string_view stage;
        sim::State& state;
        sim::Scratch<float>* scratch;
    };
    using Tamper = std::function<void(const Moment&)>;

    const Scenario& scenario;
    std::span<const TimedCommand> commands;  // sorted by tick
    sim::StepOptions options;
    Tamper tamper = nullptr;
};

// Steps a state and nothing else: no recorder, no peaks.
class Run {
  public:
    explicit Run(const Side& side);
    Run(const Run&) = delete;
    Run& operator=(const Run&) = delete;

    // Errors: the commands of the tick are not fit for it; nothing has changed.
    Outcome<void> advance();
    const sim::State& state() const { return state_; }

  private:
    friend class StageByStage;
    std::span<const sim::Command> due() { return source_.due(state_, side_.commands); }

    Side side_;
    sim::State state_;
    sim::Engine engine_;
    CommandSource source_;
};

// How a field differs between two runs.
struct FieldDifference {
    struct Value {
        std::uint32_t bits = 0;
        float number = 0;
    };
    std::string field;      // sim/named_fields.h
    std::size_t count = 0;  // differing values; a field on faces has one row and column more than vertices
    int x = 0, y = 0;       // of the first differing value, by rows from the south; −1 is the halo
    std::array<Value, 2> values;
    std::uint64_t ulps = 0;  // distance in floats; zero and minus zero are 1 apart
};

// Where two runs part.
struct Divergence {
    enum class Where {
        kStart,    // before the first tick
        kStage,    // after a stage of the plain step
        kSweep,    // the plain steps of both agree, so a swept step is wrong
        kLost,     // the tick agrees when repeated: the fault is intermittent
        kElse,     // the plain steps have different stages: another model, scheme or number of sub-steps
        kRefused,  // a run does not take the commands of the tick; it is `wrong_side`, `name` is the reason
    };
    Where where = Where::kStage;
    std::int64_t tick = 0;  // that starts alike and ends differently
    int substep = 0;        // of kStage, as in sim::StageWatch
    int substeps = 0;       // of that tick
    int stage = 0;          // number within the sub-step, from 1
    std::string name;       // of the stage
    // Of kSweep: the run that differs from the plain step, 0 or 1, if only one does.
    std::optional<int> wrong_side;

    // The differing fields after that stage, or else at the end of that tick. None: sources or the mass
    // ledger differ, but no field.
    std::vector<FieldDifference> fields;
    int tile_x = 0, tile_y = 0;  // tile of the first value of the first field, in the first run's layout
    int tile_width = 64, tile_height = 32;  // vertices
    std::vector<std::uint8_t> cells;        // grid.size(), 1 where the states differ at the end of the tick
};

// Follows one run with another, tick by tick, until they part.
class LockstepRun {
  public:
    // `first` describes the followed run, `second` the one stepped here. Both must have the same grid.
    LockstepRun(const Side& first, const Side& second);
    ~LockstepRun();

    // Call with the first run's state before its first tick and after every tick. Does the same ticks. If a
    // tick ends differently, repeats it stage by stage.
    std::optional<Divergence> follow(const sim::State& first);

  private:
    Side first_, second_side_;
    Run second_;
    sim::Snapshot before_first_, before_second_;
};

// Plays both for this many ticks, or until they part. Calls `after_tick` with each tick.
std::optional<Divergence> first_divergence(const Side& a, const Side& b, std::int64_t ticks,
                                           const std::function<void(std::int64_t)>& after_tick = nullptr);

// Number of floats from one to the other; NaNs are beyond infinity.
std::uint64_t ulps_between(float a, float b);

}  // namespace game
