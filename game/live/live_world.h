#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include <glm/vec2.hpp>

#include "game/analysis/score.h"
#include "game/base/outcome.h"
#include "game/controls/hand.h"
#include "game/recording/json_values.h"
#include "game/session/sandbox.h"

namespace game {

// A world that a web page plays: a session with the hand of a person on it, and the rules of a challenge, as the window has
// them. It begins as a recording that is watched, and proven, until the person takes over. What is done from then on is
// recorded in memory.
class LiveWorld {
  public:
    // `recording`: the text of one; `name`: what a fork calls it. Errors: as read_recording(), and a flow demo, which has
    // nothing to take over (status 2).
    static Outcome<LiveWorld> open(const std::string& recording, std::string name);

    const Sandbox& sandbox() const { return sandbox_; }
    const sim::State& state() const { return sandbox_.session().state(); }
    // The forest of tick 0, whose trees the page has; empty if there was none.
    const sim::Field<sim::Stems>& first_forest() const { return first_forest_; }

    // Runs ticks with what the hand does. Returns how many were done: fewer than asked for at the end of what is watched.
    // A sentence if something was refused or went wrong; then the last tick may have been done without the hand.
    struct Advanced {
        int ticks = 0;
        std::optional<Failure> told;
    };
    Advanced advance(int ticks);
    // Goes toward a known tick, by so many ticks at most. True on arrival. Errors: as Sandbox::tick().
    Outcome<bool> seek(std::int64_t tick, int most_ticks);
    // From here on the person acts. Errors (status 2): the recording is not proven up to here, in words for the person.
    Outcome<void> take_over();

    // The hand: at a place on the ground, m east and north of vertex (0, 0), or off it.
    void press(Modifiers with, glm::dvec2 at);
    void move_to(std::optional<glm::dvec2> at) { hand_.move_to(at); }
    void release() { hand_.release(); }
    // Whether the stroke would have commands in a tick now. In a pause, time moves for these alone; a stroke without any
    // goes on here.
    bool would_act();
    const Hand& hand() const { return hand_; }
    // {"tool":"blast","radius":12,"numbers":[1],"standing":false,"slope":[30,45]}: each member may be missing. Errors
    // (status 2): an unknown tool, or a number outside its range.
    Outcome<void> set_brush(const Json& brush);

    // Returns the name of what was undone or redone. Errors: as Sandbox's.
    Outcome<std::string> undo();
    Outcome<std::string> redo();

    // The recording as if it ended here. Errors: nothing was done yet.
    Outcome<std::string> recorded() const { return sandbox_.recorded_so_far(); }
    // The same up to its last whole line, without an end: for when no memory is left. Nothing if nobody took over.
    std::string_view recorded_in_place() const {
        const Recorder* const recorder = sandbox_.session().recorder();
        return recorder ? recorder->text_in_place() : std::string_view();
    }
    // What the try at the challenge came to; null until it ends.
    const Score* score() const { return score_ ? &*score_ : nullptr; }

    // What stays the same while the world is open: its tools with their numbers, and the challenge.
    Json facts() const;
    // What is known now: time, what can be undone, what is left of a challenge's tools, how it ended.
    Json status() const;

  private:
    LiveWorld(Sandbox sandbox, std::string name, std::optional<render::FlowLook> look);
    void judge();
    void fit_hand();

    Sandbox sandbox_;
    std::string name_;
    sim::Field<sim::Stems> first_forest_;
    std::optional<render::FlowLook>
        look_;  // of the debris, until a person takes over: the proof needs no fronts
    Hand hand_;
    std::optional<Score> score_;
};

}  // namespace game
