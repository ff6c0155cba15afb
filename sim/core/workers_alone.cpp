// Workers where there are no threads: the caller does everything.
#include "sim/core/check.h"
#include "sim/core/workers.h"

namespace sim {

class Workers::Crew {};

Workers::Workers(int threads) : threads_(threads) {
    CHECK(threads == 1);
}

Workers::~Workers() = default;

void Workers::run(int rows, Call call, void* callable) {
    if (rows > 0) call(callable, 0, 0, rows);
}

}  // namespace sim
