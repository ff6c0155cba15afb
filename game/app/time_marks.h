#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "game/recording/format.h"
#include "game/session/session.h"
#include "game/ui/facts.h"

namespace game {

// Moments of a world that a person may want to jump to: what was done, and what the flow hit. Those of known time stay when
// the world goes back.
class TimeMarks {
  public:
    static constexpr std::size_t kMost = 200;  // later ones are left out
    TimeMarks() { marks_.reserve(kMost); }

    // Another world; `known`: what will be done in it, of a recording that is watched.
    // `stops`: ticks of a lesson.
    void begin(std::span<const TimedCommand> known, std::span<const std::int64_t> stops = {});
    // Call after each tick with the commands at its start.
    void see(const Session& session, std::span<const sim::Command> commands);
    // What came after this tick is not known any more.
    void forget_after(std::int64_t tick);

    std::span<const ui::TimeMark> all() const { return marks_; }  // by tick
    // The nearest mark before or after a tick.
    std::optional<std::int64_t> before(std::int64_t tick) const;
    std::optional<std::int64_t> after(std::int64_t tick) const;

  private:
    void add_command(std::int64_t tick, sim::CommandKind kind);
    void add(ui::TimeMark mark);

    std::vector<ui::TimeMark> marks_;
    std::int64_t known_until_ = 0;            // ticks whose commands are marked
    std::int64_t seen_until_ = 0;             // ticks whose hits are marked
    std::optional<sim::CommandKind> kind_{};  // of the last command, and its tick
    std::int64_t tick_ = 0;
    int damage_ = 0;  // of all that stands, as last seen
};

}  // namespace game
