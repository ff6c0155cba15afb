#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include <glm/vec2.hpp>

#include "game/base/outcome.h"
#include "game/recording/reader.h"

namespace game {

// How long after the end of the recording a delayed command may come: an hour. All of that time is run and
// recorded.
inline constexpr std::int64_t kMostTicksAfterEnd = 60 * 60 * 60;

// A command of a recording, and the change to make to it.
struct Edit {
    struct Set {
        std::string members;  // "x=80,rate=400,as=standing", named as in the recording
    };
    struct Delete {};
    struct Move {
        glm::dvec2 by{0};  // m, to the east and to the north
    };
    struct Delay {
        double seconds = 0;  // negative: earlier; rounded to whole ticks
    };

    std::int64_t tick = 0;
    std::optional<int> which;  // of those in that tick, from 1; none: the only one
    std::variant<Set, Delete, Move, Delay> change;
};

struct Edited {
    std::vector<TimedCommand> commands;  // sorted by tick
    std::string change;                  // for display: "pour of tick 60: x=80 becomes x=100"
};
// Errors, without the file's name: no such command, or the change is not allowed.
Outcome<Edited> edited(const Recording& recording, const Edit& edit);

}  // namespace game
