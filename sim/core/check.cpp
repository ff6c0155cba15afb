#include "sim/core/check.h"

#include <cstdio>
#include <cstdlib>

namespace sim {

// The only place where sim writes to a stream: the process is about to abort, and a maintainer needs the
// line.
void check_failed(const char* condition, const char* file, int line) {
    std::fprintf(stderr, "%s:%d: CHECK failed: %s\n", file, line, condition);
    std::abort();
}

}  // namespace sim
