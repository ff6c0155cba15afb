#pragma once

#include <cstdint>

namespace test {

// The work of this thread so far, in two counts that do not depend on clocks or on other load.
struct Work {
    std::int64_t steps =
        0;  // basic blocks of our readers, and of the headers compiled into them, that were run
    std::int64_t bytes = 0;  // requested from malloc by any code, including libraries

    Work operator-(const Work& other) const { return {steps - other.steps, bytes - other.bytes}; }
};
Work work();

}  // namespace test
