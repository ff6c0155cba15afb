#pragma once

#include <exception>

#include "game/base/outcome.h"

namespace game {

// What a process is given by whoever starts it, made safe before anything else is done: descriptors 0 to 2
// that are closed are opened so that no file gets their number and writing to them fails; a limit on the size
// of files (`ulimit -f`) is a failed write, not a signal; an exception that leaves a thread is a sentence and
// status 3. Errors: the stack is too small to work on (`ulimit -s`).
Outcome<void> prepare_process();

// Why a command ended that threw an exception: memory or threads that the system does not give, or what
// nobody foresaw. Status 3.
Failure failure_of(const std::exception& thrown);

// Writes what is left in standard output. Errors: not all of it could be written, now or before.
Outcome<void> finish_standard_output();

}  // namespace game
