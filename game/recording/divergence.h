#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "game/scene/scenario.h"
#include "sim/engine.h"
#include "sim/world/snapshot.h"
#include "sim/world/state.h"

namespace game {

// One of two runs that are compared bit by bit.
struct Side {
    // May change what it is shown: how tests plant a fault. `scratch` is null after a swept tick, of which
    // `stage` is "sweep".
    struct Moment {
        std::int64_t tick;
        int substep, number;  // as sim::StageWatch has them
        std::string_view stage;
        sim::State& state;
        sim::Scratch<float>* scratch;
    };
    using Tamper = std::function<void(const Moment&)>;

    const Scenario& scenario;
    std::span<const TimedCommand> commands;  // in order of their ticks
    sim::StepOptions options;
    Tamper tamper = nullptr;
};

// A state that goes on, and nothing around it: no recorder, no peaks.
class Run {
  public:
    explicit Run(const Side& side);
    Run(const Run&) = delete;
    Run& operator=(const Run&) = delete;

    void advance();
    const sim::State& state() const { return state_; }

  private:
    friend class StageByStage;
    std::span<const sim::Command> due();

    Side side_;
    sim::State state_;
    sim::Engine engine_;
    std::vector<sim::Command> due_;  // kept for its memory
};

// How a field of two runs differs.
struct FieldDifference {
    struct Value {
        std::uint32_t bits = 0;
        float number = 0;
    };
    std::string field;      // sim/named_fields.h
    std::size_t count = 0;  // values that differ; a field on faces has one row and column more than vertices
    int x = 0, y = 0;       // of the first that does, by rows from the south; −1 is the halo
    std::array<Value, 2> values;
    std::uint64_t ulps = 0;  // between them: how many floats on; zero and minus zero are 1 apart
};

// Where two runs part.
struct Divergence {
    enum class Where {
        kStart,  // before the first tick
        kStage,  // of the plain step
        kSweep,  // the plain steps of both agree, and so one that was swept is wrong
        kLost,   // the tick done once more agrees: it does not happen every time
        kElse,   // the plain steps have not the same stages: another model, scheme or number of sub-steps
    };
    Where where = Where::kStage;
    std::int64_t tick = 0;          // that begins alike and does not end alike
    int substep = 0;                // of kStage, as sim::StageWatch has them
    int substeps = 0;               // of that tick
    int stage = 0;                  // number within the sub-step, from 1
    std::string name;               // of the stage
    std::optional<int> wrong_side;  // of kSweep: which one leaves the plain step, 0 or 1, if one alone does

    // After that stage, or else at the end of that tick; none: sources or the mass ledger differ, no field.
    std::vector<FieldDifference> fields;
    int tile_x = 0, tile_y = 0;  // of the first value of the first field, as the first run lays them out
    int tile_width = 64, tile_height = 32;  // vertices
    std::vector<std::uint8_t> cells;        // grid.size(), 1 where the states differ at the tick's end
};

// Follows a run with another one, tick by tick, until they part.
class LockstepRun {
  public:
    // `first` is what is followed, `second` what this one does. Both must be on one grid.
    LockstepRun(const Side& first, const Side& second);
    ~LockstepRun();

    // To be called with the first run's state before its first tick and after every one. Does the same ticks,
    // and where they do not end alike goes through the last one again, stage by stage.
    std::optional<Divergence> follow(const sim::State& first);

  private:
    Side first_, second_side_;
    Run second_;
    sim::Snapshot before_first_, before_second_;
};

// Plays both for so many ticks, or until they part. `after_tick` is told of each.
std::optional<Divergence> first_divergence(const Side& a, const Side& b, std::int64_t ticks,
                                           const std::function<void(std::int64_t)>& after_tick = nullptr);

// How many floats it is from one to the other; NaNs are beyond infinity.
std::uint64_t ulps_between(float a, float b);

}  // namespace game
