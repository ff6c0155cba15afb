#pragma once

#include <cstdint>

namespace test {

// What this thread has done so far, by two counts that no clock and no other load changes.
struct Work {
    std::int64_t steps =
        0;  // basic blocks of our readers, and of the headers compiled into them, that were run
    std::int64_t bytes = 0;  // asked of malloc by anything, libraries included

    Work operator-(const Work& other) const { return {steps - other.steps, bytes - other.bytes}; }
};
Work work();

}  // namespace test
