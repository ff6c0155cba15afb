#pragma once

#include <cstdint>
#include <deque>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "game/base/outcome.h"
#include "game/recording/command_source.h"
#include "game/session/keyframes.h"
#include "game/session/loaded_world.h"
#include "game/session/session.h"
#include "game/session/verifier.h"

namespace game {

// What was done in a world since it began.
struct History {
    std::vector<TimedCommand> scene;    // its own commands, all of them, sorted by tick
    std::vector<TimedCommand> by_hand;  // those of a person so far, sorted by tick
};

// An interactive session without a window: scheduled commands of a scene or a watched recording, user
// commands, seeking and undo.
class Sandbox {
  public:
    // Without a recorder the session is not recorded. A watched recording needs none until the user takes
    // over.
    static Outcome<Sandbox> begin(LoadedWorld loaded, const sim::StepOptions& options,
                                  std::optional<Recorder> recorder);

    const Scenario& scenario() const { return opening_.scene.scenario; }
    const LoadedWorld& opening() const { return opening_; }  // what it began with
    const Session& session() const { return session_; }
    // From now on fronts are tracked and carry a texture, as `look` has it; for a world that began without.
    void follow_fronts(const render::FlowLook& look);
    void set_flow(const sim::fields::FlowNumbers& numbers) { session_.set_flow(numbers); }

    // Last tick whose commands are known, from the recording or because it was played before.
    std::int64_t known_until() const { return known_until_; }
    // True while replaying a known tick; user commands are ignored.
    bool looks_back() const { return session_.state().tick < known_until_; }
    // True for a watched recording until the user takes over.
    bool watches() const { return opening_.watched.has_value(); }
    bool watched_to_end() const { return watches() && !looks_back(); }
    // Whether the user has changed this world, other than by what was undone.
    bool was_touched() const { return !by_hand_.empty(); }
    // The tick of the user's first command in this world.
    std::optional<std::int64_t> first_action() const {
        return by_hand_.empty() ? std::nullopt : std::optional(by_hand_.front().tick);
    }
    // The comparison with the watched recording so far.
    std::optional<Verdict> verdict() const;

    // Seeks toward `tick`, 0 to known_until(), while `may_go_on` returns true. Returns true on arrival. A
    // flow demo cannot seek: false. Errors: as for tick().
    Outcome<bool> go_toward(std::int64_t tick, const std::function<bool()>& may_go_on);
    bool can_go_back() const { return !scenario().flow; }
    const Keyframes& keyframes() const { return keyframes_; }

    // Continues from this tick; later known commands are discarded. The earlier recording, if any, keeps
    // them, and `open` gives the place of its fork. Errors: a recording cannot be read or written; the session then
    // continues unrecorded.
    Outcome<void> take_over(const RecordingStore::Open& open);

    // Later user commands form one undoable action. `name` is shown to the user: "pour".
    void begin_action(std::string name);
    // Runs one tick with the user commands in `hand`; they are ignored while replaying. Errors, worded as a
    // notice (the tick was done): inconsistent parameters were dropped; the recording cannot be written, and
    // the session continues unrecorded; or mass was not conserved.
    Outcome<void> tick(std::span<const sim::Command> hand);

    // Those that the last tick began with: of the scene or the recording, and the user's.
    std::span<const sim::Command> last_commands() const { return source_.commands(); }

    // What is left of each of the goal's tools until now. Only of a world with a goal.
    GoalUse goal_use() const;
    // The user's commands in known time, sorted by tick. Valid until the next tick.
    std::span<const TimedCommand> by_hand() const { return by_hand_; }
    // What was done in this world, its own commands and a person's apart. What was done in a recording before it was
    // taken over counts as a person's.
    History history() const;
    // Everything that was done before this tick, sorted by tick; in each the scene or the recording first.
    std::vector<TimedCommand> commands_so_far() const;

    std::size_t actions() const { return past_.size(); }   // that can be undone
    std::size_t undone() const { return undone_.size(); }  // actions that can be redone
    // Rewinds world and recording to just before the last action. Returns its name. Errors: there is nothing
    // to undo, the current tick is in the past, or the recording cannot be written.
    Outcome<std::string> undo();
    // Makes what the last undo took back known again, up to known_until(), which the caller may seek to. Returns
    // its name. Nothing can be redone any more once the user has done something else. Errors: as for undo().
    Outcome<std::string> redo();

    // The text of the recording up to now, as if it ended here. Errors: nothing is recorded, or it cannot be read.
    Outcome<std::string> recorded_so_far() const;

    // Closes the recording. Errors: the recording cannot be written.
    Outcome<void> finish() { return session_.finish(); }
    // Writes what a try came to that ended in this tick (Session::claim()).
    Outcome<void> claim(const ClaimLine& line) { return session_.claim(line); }

  private:
    struct Action {
        std::string name;
        Session::Checkpoint before;
        int store = 0;  // count of stores when it began; its mark is of that one
    };
    struct Undone {
        Action action;
        std::vector<TimedCommand> by_hand;  // from its first tick on
        std::int64_t known_until = 0;
    };
    Sandbox(LoadedWorld loaded, Session session);
    void remember();
    void forget_after(std::int64_t tick);
    Outcome<void> gather(std::span<const sim::Command> hand);
    Outcome<void> add_allowed(std::span<const sim::Command> hand);
    Outcome<void> advance();
    bool may_change_history() const { return !looks_back() || returns_; }
    Outcome<void> go_to_just_before(const Action& action);
    Outcome<void> fork_again_at(const Session::Checkpoint& moment);
    void forget_actions_after(std::int64_t tick);
    Outcome<Recorder> fork(const RecordingStore::Open& open) const;

    LoadedWorld opening_;
    Session session_;
    std::optional<Verifier> verifier_;
    std::vector<TimedCommand> by_hand_;  // sorted by tick
    CommandSource source_;
    Keyframes keyframes_;
    std::int64_t known_until_ = 0;
    std::optional<std::string> new_action_;  // begun, without a command yet
    std::deque<Action> past_;
    std::vector<Undone> undone_;  // the last one is redone first
    int stores_ = 0;              // that this session was recorded in so far
    bool returns_ = false;        // from redo() until its last tick is reached
};

}  // namespace game
