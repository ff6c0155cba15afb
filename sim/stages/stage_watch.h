#pragma once

#include <functional>
#include <string_view>

namespace sim {

// Reports each stage of a plain step when it has finished all rows, to compare two runs stage by stage or to
// inject a fault. A sweep interleaves its stages over the rows, so it reports none.
struct StageWatch {
    static constexpr int kCommands = -1;

    // May be empty. `substep` counts from 0; kCommands is before the first one, and the number of sub-steps
    // is after the last one. `number` counts the stages of a sub-step from 1.
    std::function<void(int substep, int number, std::string_view stage)> look;

    void begin(int new_substep) { substep = new_substep, number = 0; }
    void done(std::string_view stage) {
        ++number;
        if (look) look(substep, number, stage);
    }

    int substep = kCommands, number = 0;
};

}  // namespace sim
