#pragma once

#include <cstdint>
#include <deque>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "game/opening.h"
#include "game/outcome.h"
#include "game/recording/verifier.h"
#include "game/session.h"

namespace game {

// A world in a person's hands, without a window: what the scene or a watched recording has in store, what the
// hand adds, and the way back.
class Sandbox {
  public:
    // Where the session is recorded; without a recorder it is not.
    static Outcome<Sandbox> begin(Opening opening, const sim::How& how, std::optional<Recorder> recorder);

    const Start& start() const { return opening_.scene.start; }
    const Session& session() const { return session_; }
    void set_flow(const sim::fields::FlowNumbers& numbers) { session_.set_flow(numbers); }

    // A recording goes on by itself: hands off until this tick, nothing once it has been reached.
    std::optional<std::int64_t> watched_until() const;
    // How the watched recording compared so far.
    std::optional<Verdict> verdict() const;

    // What the hand gives from here on is one action, undone as a whole. `name` is for people: "pour".
    void begin_action(std::string name);
    // One tick, with what the hand gives. Errors, in words for a notice, though the tick was done: numbers
    // that do not go together were left out; the recording cannot be written, and the world goes on without
    // one; or mass was lost.
    Outcome<void> tick(std::span<const sim::Command> hand);

    std::size_t actions() const { return past_.size(); }  // that can be undone
    // Rewinds world and recording to just before the last action. Returns its name. Errors: nothing to undo,
    // or the recording cannot be written.
    Outcome<std::string> undo();

    // Closes the recording. Errors: it cannot be written.
    Outcome<void> finish() { return session_.finish(); }

  private:
    struct Action {
        std::string name;
        Session::Moment before;
    };
    Sandbox(Opening opening, Session session) : opening_(std::move(opening)), session_(std::move(session)) {}
    void remember();
    Outcome<void> leave_out_clashing(std::size_t first);
    Outcome<void> advance();

    Opening opening_;
    Session session_;
    std::optional<Verifier> verifier_;
    std::vector<sim::Command> given_;        // of this tick; kept for its memory
    std::optional<std::string> new_action_;  // begun, and nothing given yet
    std::deque<Action> past_;
    std::size_t most_actions_ = 1;
};

}  // namespace game
