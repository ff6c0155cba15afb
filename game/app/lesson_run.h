#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include <glm/vec2.hpp>

#include "game/analysis/lesson_figures.h"
#include "game/scene/lesson.h"
#include "game/ui/facts.h"

namespace game {

// A lesson under way in the window: at which tick time has to stand still, whose card is open, what was answered and
// guessed. A view, which never affects the world.
class LessonRun {
  public:
    LessonRun(const Lesson& lesson, double tick_s);

    // Ticks that time may run from this one on before it has to stand still.
    std::int64_t ticks_to_stop(std::int64_t tick) const;
    // Call when time is at a tick and on no way elsewhere. True if it has to stand still there; its card is open then.
    bool see(std::int64_t tick);
    // The stop whose card is open; null: none.
    const Lesson::Stop* open() const { return open_ ? &lesson_->stops[*open_] : nullptr; }
    // What was measured of the slide when the card was opened; call after see() has opened one.
    bool lacks_figures() const { return open_ && measured_ != open_; }
    void take(const LessonFigures& figures);

    // Closes the card. The tick of its stop, at which time goes on, wherever it was meanwhile.
    std::optional<std::int64_t> go_on();
    void answer(std::size_t answer);  // the first one counts
    bool asks_guess() const { return open_ && lesson_->stops[*open_].asks_guess; }
    void guess(glm::dvec2 at) { guess_ = at; }  // m
    const std::optional<glm::dvec2>& guessed() const { return guess_; }
    // Where the front has stopped, m: told at the last stop.
    std::optional<glm::dvec2> toe() const;

    // Of each stop.
    const std::vector<std::int64_t>& ticks() const { return ticks_; }
    // What the card shows. Valid until this is changed.
    std::optional<ui::LessonNote> note() const;

  private:
    bool is_last() const { return open_ && *open_ + 1 == ticks_.size(); }

    const Lesson* lesson_;  // outlives this
    std::vector<std::int64_t> ticks_;
    std::vector<std::optional<std::size_t>> answers_;  // of each stop
    std::optional<std::size_t> open_, measured_;       // measured_: whose figures these are
    std::optional<std::size_t> passed_;  // whose card was closed and which time has not left yet
    std::optional<glm::dvec2> guess_;
    LessonFigures figures_;
};

}  // namespace game
