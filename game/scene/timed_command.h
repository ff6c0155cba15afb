#pragma once

#include <cstdint>

#include "sim/world/command.h"

namespace game {

// A command and the tick at whose start it applies.
struct TimedCommand {
    std::int64_t tick = 0;
    sim::Command command;
    bool operator==(const TimedCommand&) const = default;
};

}  // namespace game
