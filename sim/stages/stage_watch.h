#pragma once

#include <functional>
#include <string_view>

namespace sim {

// For who compares two runs stage by stage, or puts a fault into one: is told of each stage of a plain step
// when it has gone over all rows. A sweep's stages follow one another over the rows, so of them it is told
// nothing.
struct StageWatch {
    static constexpr int kCommands = -1;

    // None: nobody looks. `substep` counts from 0; kCommands is before the first one, and as many as there
    // are is after the last one. `number` counts the stages of a sub-step from 1.
    std::function<void(int substep, int number, std::string_view stage)> look;

    void begin(int new_substep) { substep = new_substep, number = 0; }
    void done(std::string_view stage) {
        ++number;
        if (look) look(substep, number, stage);
    }

    int substep = kCommands, number = 0;
};

}  // namespace sim
