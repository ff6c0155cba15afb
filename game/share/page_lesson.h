#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "game/recording/format.h"
#include "game/scene/lesson.h"
#include "game/session/session.h"

namespace game {

// A lesson as its page has it: its texts, with what is measured of the slide at each stop. A view, which never affects the world.
class PageLesson {
  public:
    // `lesson` and `commands`, all of the slide, outlive it.
    PageLesson(const Lesson& lesson, double tick_s, std::span<const TimedCommand> commands);
    // Call at tick 0 and after each tick.
    void see(const Scenario& scenario, const Session& session);
    // Once the last stop was seen.
    const Json& json() const { return json_; }

  private:
    const Lesson* lesson_;
    std::vector<std::int64_t> ticks_;
    std::span<const TimedCommand> commands_;
    std::size_t next_ = 0;
    Json json_;
};

}  // namespace game
