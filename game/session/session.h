#pragma once

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "game/base/outcome.h"
#include "game/recording/recorder.h"
#include "game/scene/memory.h"
#include "game/scene/pressure.h"
#include "game/scene/scenario.h"
#include "game/scene/structures.h"
#include "game/session/attempt_watch.h"
#include "game/session/peak_watch.h"
#include "game/session/world_fronts.h"
#include "render/view/flow_so_far.h"
#include "sim/carried/carried.h"
#include "sim/engine.h"
#include "sim/powder/cloud.h"
#include "sim/world/snapshot.h"
#include "sim/world/state.h"

namespace game {

// Milliseconds that the stages of the last tick took. Add a member for each new stage.
struct TickTimes {
    double solve_ms = 0;
    double hash_ms = 0;
    // Tracking, advection and blending, if fronts are tracked.
    double track_ms = 0, advect_ms = 0, gradient_ms = 0;  // track_ms has all three in a flow demo
    double peaks_ms = 0;  // per-vertex maxima; count of moving vertices; powder; what flows carry
};

// Plays a world, with or without a window: commands in, views out. Records each command, if there is a
// recorder, then applies it.
class Session {
  public:
    // Everything needed to restore one tick: about 32 bytes per vertex, and 80 more if fronts are tracked.
    struct Checkpoint {
        sim::Snapshot world;
        std::optional<sim::front::TextureLayers::Memory> textures;
        std::vector<sim::powder::Puff> powder;
        std::vector<sim::carried::Body> carried;
        Peaks peaks;
        std::optional<AttemptWatch> challenge;
        StateLine line;
        std::optional<Recorder::Mark> mark;
    };

    // With a recorder, writes the state of tick 0.
    static Outcome<Session> begin(const Scenario& scenario, const sim::StepOptions& options,
                                  std::optional<Recorder> recorder);

    // Starts front tracking and texture advection for a viewer: with the flow demo of `scenario`, or with the
    // rolling layer if its look has an advected texture. At any tick; textures have never moved at a moment from
    // before it. Does nothing above `most_vertices`; the caller then reports kTooFine. OpenGL does not guarantee
    // that more than kMostFollowed can be drawn.
    void follow_fronts(const Scenario& scenario, std::size_t most_vertices = kMostFollowed);
    static constexpr const char* kTooFine =
        "Textures do not move with the flow: the grid has over 900,000 vertices. Use a smaller --grid";
    // Starts the powder over the flow, if a material of `scenario` has any and its look is not "model".
    void follow_powder(const Scenario& scenario);
    // Starts the boulders that flows of soil carry, if its look has a date and is not "model".
    void follow_carried(const Scenario& scenario);
    // Empty if they are not followed.
    std::span<const sim::carried::Body> carried() const {
        return carried_ ? carried_->bodies() : std::span<const sim::carried::Body>();
    }
    // Empty if it is not followed.
    std::span<const sim::powder::Puff> powder() const {
        return powder_ ? powder_->puffs() : std::span<const sim::powder::Puff>();
    }
    void follow_nothing() { stage_.reset(), fronts_.reset(), powder_.reset(), carried_.reset(); }
    // Null if no fronts are tracked.
    const sim::front::FlowView* fronts() const {
        return stage_ ? &stage_->view() : fronts_ ? &fronts_->view() : nullptr;
    }
    // Sets the speeds of a flow demo from the next tick on; no effect otherwise. Not recorded.
    void set_flow(const sim::fields::FlowNumbers& numbers) {
        if (stage_) stage_->set(numbers);
    }

    // Runs one tick; `commands` apply at its start. Errors: a command is out of range or the parameters are
    // inconsistent, and then nothing has changed; the recording cannot be written; or mass was not conserved,
    // which is checked every tick.
    Outcome<void> advance(std::span<const sim::Command> commands);
    // Closes the recording, and deletes what it replaced.
    Outcome<void> finish();
    // Closes the recording; what it replaced stays until delete_replaced(), because the caller may still fail.
    Outcome<void> end_recording();
    void delete_replaced();
    // The text of the recording so far, as finish() would leave it; the recording goes on. Call it only with a
    // recorder. Errors: those of Recorder::copy_ended_at().
    Outcome<std::string> recorded_so_far() const;

    Checkpoint moment() const;
    // Discards everything after `moment` in the world and in the recording; the state is bit-identical. A
    // flow demo is not rewound. Errors: the recording cannot be written.
    Outcome<void> rewind(const Checkpoint& moment);
    // Goes to `moment`, earlier or later. Keeps the recording: ticks up to recorded_until() are not written
    // again. Errors: the recording cannot be written.
    Outcome<void> go_to(const Checkpoint& moment);

    const Recorder* recorder() const { return recorder_ ? &*recorder_ : nullptr; }
    std::int64_t recorded_until() const { return recorded_until_; }  // tick
    // Continues in `recorder`, which already holds all ticks so far.
    void record_in(Recorder recorder);
    // The same at tick 0: writes its state. Errors: the recording cannot be written.
    Outcome<void> record_from_start(Recorder recorder);
    // Leaves the file as it is, without an end line, and continues unrecorded.
    void stop_recording() { recorder_.reset(); }

    sim::View view() const { return sim::view(state_); }
    const sim::State& state() const { return state_; }
    // The last tick that changed the fields, the powder or what flows carry. While the world is at rest, its frame stays the same.
    std::int64_t changed_at() const { return changed_at_; }
    const Peaks& peaks() const { return peaks_.peaks(); }
    render::FlowSoFar flow_so_far() const { return {peaks().depth, peaks().speed_plan}; }
    // What people have built, as the flow has left it.
    const render::Structures& structures() const { return structures_.structures(); }
    const std::optional<Densities>& densities() const { return densities_; }
    const TickTimes& times() const { return times_; }
    // From now on a tick does not hash its state, which saves a twentieth of it, and state_line() is that of the last
    // hash_now(). Call it only without a recorder.
    void hash_when_asked();
    std::uint64_t hash_now();
    // The state line of this tick; `before` has the hashes since the last recorded state line.
    const StateLine& state_line() const { return line_; }
    // When the try at the scenario's goal ended: tick.
    std::optional<std::int64_t> try_ended_at() const { return try_ ? try_->ended_at() : std::nullopt; }
    // What the last slab that the scene let go had left: as AttemptWatch::slab().
    std::optional<AttemptWatch::Slab> slab() const { return try_ ? try_->slab() : std::nullopt; }
    // Whether the scenario has a goal and no try at it has ended.
    bool is_in_try() const { return try_ && !try_->ended_at(); }
    // Writes what the try that ended in this tick scores, if this tick is being recorded for the first time. Errors:
    // the recording cannot be written.
    Outcome<void> claim(const ClaimLine& line);
    // Depth of the standing layer without what slid, m, one value per vertex, row 0 the south: that of tick 0, with what weather
    // has done since.
    std::span<const float> undisturbed() const { return undisturbed_; }
    std::size_t active_cells() const { return peaks_.active_cells(); }
    // As PeakWatch::energy().
    std::int64_t energy() const { return peaks_.energy(); }
    double seconds() const {
        return static_cast<double>(state_.tick) * static_cast<double>(state_.params.tick_s);
    }
    double cubic_metres(std::int64_t quanta) const;

  private:
    Session(const Scenario& scenario, const sim::StepOptions& options);
    void find_hash();
    void put(const Checkpoint& moment);
    bool lacks_state() const;
    Outcome<void> write_state();
    void find_undisturbed();
    void watch_structures() { structures_.watch(view()); }
    void advance_fronts();
    void advance_powder(std::span<const sim::Command> commands, bool rests);

    sim::State state_;
    std::unique_ptr<sim::Engine> engine_;
    std::optional<Recorder> recorder_;
    std::unique_ptr<sim::fields::FlowStage> stage_;
    std::unique_ptr<WorldFronts> fronts_;
    std::optional<sim::powder::Cloud> powder_;
    std::optional<sim::carried::Carried> carried_;
    std::vector<float> undisturbed_;  // where fronts_ look for it, too
    std::optional<Densities> densities_;
    PeakWatch peaks_;
    StructureWatch structures_;
    std::optional<AttemptWatch> try_;  // of a challenge
    TickTimes times_;
    std::int64_t changed_at_ = 0;
    StateLine line_;
    bool hashes_ = true;               // each tick
    std::int64_t recorded_until_ = 0;  // tick
};

}  // namespace game
