#pragma once

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "game/base/outcome.h"
#include "game/recording/recorder.h"
#include "game/scene/memory.h"
#include "game/scene/scenario.h"
#include "game/session/world_fronts.h"
#include "sim/engine.h"
#include "sim/world/snapshot.h"
#include "sim/world/state.h"

namespace game {

// Milliseconds that the stages of the last tick took. Grows with the stages.
struct TickTimes {
    double solve_ms = 0;
    double hash_ms = 0;
    // Of its fronts, where they are followed: finding them, carrying textures, what is seen of these.
    double track_ms = 0, advect_ms = 0, gradient_ms = 0;  // of a flow that is shown, all under track_ms
    double peaks_ms = 0;  // what each vertex has seen at most, and how many move
};

// The greatest values that each vertex has seen, grid.size() each: what an avalanche did, when it is over. A
// view.
struct Peaks {
    std::vector<float> depth;                 // m, of the rolling layer
    std::vector<float> speed;                 // m/s, where that layer was at least kVisible deep
    static constexpr float kVisible = 0.01f;  // m
};

// A world being played, with or without a window: commands in, views out. Whatever it is told it records
// first, if it has a recorder, and then does.
class Session {
  public:
    // All of a session at one tick, to come back to: a plain value of some 24 bytes per vertex, and 80 more
    // where fronts are followed.
    struct Checkpoint {
        sim::Snapshot world;
        std::optional<sim::front::TextureLayers::Memory> textures;
        Peaks peaks;
        std::size_t active_cells = 0;
        StateLine line;
        std::optional<Recorder::Mark> mark;
    };

    // With a recorder, writes the state of tick 0.
    static Outcome<Session> begin(const Scenario& scenario, const sim::StepOptions& options,
                                  std::optional<Recorder> recorder);

    // From here on, for who draws or measures it: fronts, and what is carried with the flow that `scenario`
    // shows or, if its look says that it carries anything, with the rolling layer.
    // Where there are more vertices than that nothing is followed, and whoever asked should say kTooFine: no
    // GL need be able to draw more than kMostFollowed.
    void follow_fronts(const Scenario& scenario, std::size_t most_vertices = kMostFollowed);
    static constexpr const char* kTooFine =
        "Textures do not move with the flow: the grid has over 900,000 vertices. Use a smaller --grid";
    void follow_nothing() { stage_.reset(), fronts_.reset(); }
    // Nothing while none are followed.
    const sim::front::FlowView* fronts() const {
        return stage_ ? &stage_->view() : fronts_ ? &fronts_->view() : nullptr;
    }
    // Of a start's flow that is followed, from the next tick on; without one nothing happens. Not recorded: a
    // view.
    void set_flow(const sim::fields::FlowNumbers& numbers) {
        if (stage_) stage_->set(numbers);
    }

    // One tick, with the commands given at its start. Errors: a command is out of range or the numbers set do
    // not go together, and then nothing has changed; the recording cannot be written; or mass was lost, which
    // is checked every tick.
    Outcome<void> advance(std::span<const sim::Command> commands);
    // Closes the recording.
    Outcome<void> finish();

    Checkpoint moment() const;
    // Takes back all that came after `moment`, in the world and in the recording, to the bit. A flow that
    // is shown goes on: nothing that a hand does touches it. Errors: the recording cannot be written.
    Outcome<void> rewind(const Checkpoint& moment);
    // To `moment`, earlier or later. The recording stays as it is: what it has already, up to
    // recorded_until(), is not written again. Errors: it cannot be written.
    Outcome<void> go_to(const Checkpoint& moment);

    const Recorder* recorder() const { return recorder_ ? &*recorder_ : nullptr; }
    std::int64_t recorded_until() const { return recorded_until_; }  // tick
    // From here on in this recording, which has all up to this tick.
    void record_in(Recorder recorder);
    // Leaves the file as it is, without an end, and plays on unrecorded.
    void stop_recording() { recorder_.reset(); }

    sim::View view() const { return sim::view(state_); }
    const sim::State& state() const { return state_; }
    // The tick that changed the fields last: while the world is at rest its picture stays the same.
    std::int64_t changed_at() const { return changed_at_; }
    const Peaks& peaks() const { return peaks_; }
    const TickTimes& times() const { return times_; }
    // Of this tick; `before` goes back to the last tick that a recording has a line of.
    const StateLine& state_line() const { return line_; }
    std::size_t active_cells() const { return active_cells_; }  // vertices whose rolling layer is not empty
    double seconds() const {
        return static_cast<double>(state_.tick) * static_cast<double>(state_.params.tick_s);
    }
    double cubic_metres(std::int64_t quanta) const;

  private:
    Session(const Scenario& scenario, const sim::StepOptions& options, std::optional<Recorder> recorder);
    void find_hash();
    void put(const Checkpoint& moment);
    Outcome<void> write_state();
    void watch();
    void advance_fronts();

    sim::State state_;
    std::unique_ptr<sim::Engine> engine_;
    std::optional<Recorder> recorder_;
    std::unique_ptr<sim::fields::FlowStage> stage_;
    std::unique_ptr<WorldFronts> fronts_;
    Peaks peaks_;
    TickTimes times_;
    std::size_t active_cells_ = 0;
    std::int64_t changed_at_ = 0;
    StateLine line_;
    std::int64_t recorded_until_ = 0;  // tick
};

}  // namespace game
