#pragma once

#include <cstdint>
#include <deque>
#include <filesystem>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "game/base/outcome.h"
#include "game/session/keyframes.h"
#include "game/session/loaded_world.h"
#include "game/session/session.h"
#include "game/session/verifier.h"

namespace game {

// A world in a person's hands, without a window: what the scene or a watched recording has in store, what the
// hand adds, and the way back and forth in time.
class Sandbox {
  public:
    // Where the session is recorded; without a recorder it is not, and a watched recording needs none before
    // it is taken over.
    static Outcome<Sandbox> begin(LoadedWorld loaded, const sim::StepOptions& options,
                                  std::optional<Recorder> recorder);

    const Scenario& scenario() const { return opening_.scene.scenario; }
    const Session& session() const { return session_; }
    void set_flow(const sim::fields::FlowNumbers& numbers) { session_.set_flow(numbers); }

    // Up to this tick it is known what happens: the recording tells, or the person has been there.
    std::int64_t known_until() const { return known_until_; }
    // Time stands before that, and goes on as it is known to: hands off.
    bool looks_back() const { return session_.state().tick < known_until_; }
    // A recording that somebody made is being watched, or was until just now and has not been taken over.
    bool watches() const { return opening_.watched.has_value(); }
    bool watched_to_end() const { return watches() && !looks_back(); }
    // How the watched recording compared so far.
    std::optional<Verdict> verdict() const;

    // Toward `tick`, from 0 to known_until(), earlier or later, for as long as `may_go_on` says; true once
    // there. A flow that is shown cannot go back: false. Errors: as of tick().
    Outcome<bool> go_toward(std::int64_t tick, const std::function<bool()>& may_go_on);
    bool can_go_back() const { return !scenario().flow; }
    const Keyframes& keyframes() const { return keyframes_; }

    // From here on the world is the person's. What was known to come after this tick is given up; it stays in
    // the recording that told it, if one did, and `path` goes on from that one; without it nothing is
    // recorded. Errors: a recording cannot be read or written, and then the world goes on without one.
    Outcome<void> take_over(const std::optional<std::filesystem::path>& path);

    // What the hand gives from here on is one action, undone as a whole. `name` is for people: "pour".
    void begin_action(std::string name);
    // One tick, with what the hand gives; nothing while it looks back. Errors, in words for a notice, though
    // the tick was done: numbers that do not go together were left out; the recording cannot be written, and
    // the world goes on without one; or mass was lost.
    Outcome<void> tick(std::span<const sim::Command> hand);

    std::size_t actions() const { return past_.size(); }  // that can be undone
    // Rewinds world and recording to just before the last action. Returns its name. Errors: nothing to undo,
    // time stands before it, or the recording cannot be written.
    Outcome<std::string> undo();

    // Closes the recording. Errors: it cannot be written.
    Outcome<void> finish() { return session_.finish(); }

  private:
    struct Action {
        std::string name;
        Session::Checkpoint before;
    };
    Sandbox(LoadedWorld loaded, Session session, std::size_t bytes_per_moment);
    void remember();
    void forget_after(std::int64_t tick);
    void give_due(const std::vector<TimedCommand>& commands);
    Outcome<void> leave_out_clashing(std::size_t first);
    Outcome<void> advance();
    Outcome<Recorder> fork_in(const std::filesystem::path& path) const;

    LoadedWorld opening_;
    Session session_;
    std::optional<Verifier> verifier_;
    std::vector<TimedCommand> by_hand_;  // in order of their ticks
    std::vector<sim::Command> given_;    // of this tick; kept for its memory
    Keyframes keyframes_;
    std::int64_t known_until_ = 0;
    std::optional<std::string> new_action_;  // begun, and nothing given yet
    std::deque<Action> past_;
    std::size_t most_actions_ = 1;
};

}  // namespace game
