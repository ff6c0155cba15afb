#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "game/analysis/measures.h"
#include "game/base/outcome.h"
#include "game/recording/format.h"
#include "game/scene/scenario.h"
#include "game/session/session.h"

namespace game {

// What a try at a challenge came to. Every number follows from states and commands alone.
struct Score {
    static constexpr std::int64_t kParts = 1000;  // values are whole thousandths of the measure's unit

    struct Judged {
        std::int64_t value = 0;
        bool met = true;
    };
    std::int64_t tick = 0;      // at which the try ended
    std::vector<Judged> needs;  // as the goal has them
    Measures measures;          // of the slide until then
    std::int64_t points = 0;
    int medal = 0;  // 0 none, 1 bronze, 2 silver, 3 gold; 0 if a need is not met

    bool meets_needs() const;
    bool won() const { return medal > 0; }
    ClaimLine claim() const { return {tick, points, medal}; }
};

// Judges the state that a session is in, which must be that of the tick in which the try ended. `commands`: all of this
// world until now, sorted by tick. Needs a scenario with a goal.
Score score_now(const Scenario& scenario, const Session& session, std::span<const TimedCommand> commands);

// What the area of a deposit (m³), or of snow removed (%), has come to until now. Costs a pass over the grid.
double amount_in_area(const Scenario& scenario, const Session& session, const Quantity& quantity);

inline constexpr int kGold = 3;
const char* medal_name(int medal);  // "gold"
// "greatest load on a house", "8.2 kPa" and "at most 5 kPa".
struct NeedText {
    std::string what, value, bound;
};
NeedText text_of(const Goal::Need& need, const Score::Judged& judged);
// "Won: silver", "No medal" or "Lost".
std::string verdict_of(const Score& score);
// Why it is not won, by the first need that is not met; empty if it is.
std::string reason_of(const Goal& goal, const Score& score);
// Both, the score and each need as lines.
std::string to_text(const Goal& goal, const Score& score);
Json to_json(const Goal& goal, const Score& score);

// What breaks a rule of the challenge before a tick, as "tick 60: …": a command of a person that no tool allows, or an event of
// the scene that is missing. `commands`: sorted by tick. Nothing if all is as it may be.
std::optional<std::string> broken_rule(const Scenario& scenario, std::span<const TimedCommand> commands,
                                       std::int64_t until);

// Watches a session from tick 0 and scores its try at the moment at which it ends.
class Referee {
  public:
    // Both outlive it. `commands`: that the session will be given, sorted by tick.
    Referee(const Scenario& scenario, std::span<const TimedCommand> commands)
        : scenario_(scenario), commands_(commands) {}

    // Call after every tick.
    void see(const Session& session);
    // The score. Errors: the try did not end (status 1), or a command broke a rule of the challenge (status 2): its
    // tick and what forbids it.
    Outcome<Score> decide() const;

  private:
    const Scenario& scenario_;
    std::span<const TimedCommand> commands_;
    std::optional<Score> score_;
};

// Whether two scenarios are the same challenge: all but how they are drawn and called is the same.
bool is_same_challenge(const Scenario& one, const Scenario& other);
// 16 hexadecimal digits that tell challenges apart as is_same_challenge() does, whatever format recordings have.
std::string challenge_id(const Scenario& scenario);

}  // namespace game
