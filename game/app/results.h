#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "game/analysis/best_runs.h"
#include "game/analysis/score.h"
#include "game/session/sandbox.h"
#include "game/ui/facts.h"

namespace game {

// Watches for the end of an attempt and of slides in free play, and keeps the card that tells what they came to. Of one
// open world. A view, which never affects the world.
class Results {
  public:
    // Call after each tick. The score of an attempt at the goal that ended in it, if it was not scored before; the pointer is
    // valid until the next call. A score whose moment was taken back is forgotten. `earlier`: the best runs so far,
    // the best first.
    const Score* judge_attempt(const Sandbox& sandbox, std::span<const BestRun> earlier);
    // Call after the ticks of a frame. A slide in free play ends as soon as only creep is left of it (`creeps`). If it was
    // too small for a card: what was swept along, m³.
    std::optional<double> judge_slide(const Sandbox& sandbox, bool creeps);
    // Call after the ticks of a frame. How long a slide went on that has come to rest in them, s.
    std::optional<double> came_to_rest(const Sandbox& sandbox);

    // To be shown at this time of the world; null if there is none, or if it was closed.
    const ui::ResultCard* card(const Sandbox& sandbox) const;
    void close_card() { shows_card_ = false; }
    std::int64_t began() const { return began_; }  // tick at which what the card tells began

    // A slide has ended that was not shared since.
    bool may_share() const { return may_share_; }
    void set_may_share(bool may) { may_share_ = may; }

  private:
    void show(ui::ResultCard card, const Sandbox& sandbox, std::int64_t began);

    std::optional<double> sliding_since_;  // s of the world, while something moves
    std::optional<double> running_since_;  // the same, while more than creep does
    bool may_share_ = false;
    std::optional<Score> score_;         // of an attempt that has ended
    std::optional<std::int64_t> ended_;  // tick at which that, or a slide in free play, ended
    ui::ResultCard card_;                // that tells it
    std::int64_t began_ = 0;
    bool shows_card_ = false;
};

}  // namespace game
