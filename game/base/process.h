#pragma once

#include <exception>
#include <filesystem>

#include "game/base/outcome.h"

namespace game {

// Makes the inherited process state safe; to be called first. Closed descriptors 0 to 2 are opened, so that
// no file gets their number and writing to them fails. A limit on file size (`ulimit -f`) becomes a failed
// write, not a signal. An exception that leaves a thread prints a sentence and ends with status 3. Errors:
// the stack is too small (`ulimit -s`).
Outcome<void> prepare_process();

// Why a command ended with an exception: the system denied memory or threads, or an unexpected error. Status
// 3.
Failure failure_of(const std::exception& thrown);

// From now on Ctrl+C (SIGINT), or SIGTERM, only answers interrupted(); a second one ends the process.
void note_interrupts();
bool interrupted();

// Flushes standard output. Errors: some of it could not be written, now or before.
Outcome<void> finish_standard_output();

// Gives the calling thread, and those that it starts, what processor time others leave.
void lower_priority_of_thread();

inline constexpr int kMostThreads = 64;  // that a user may ask for
// How many processors the machine has, at least 1.
int processors();

// Asks the desktop to show a folder, with xdg-open. Returns false if there is no such program.
bool show_folder(const std::filesystem::path& folder);

}  // namespace game
