#pragma once

#include "game/base/outcome.h"

namespace game {

// Reads the command line, runs the subcommand it names and returns its exit status; --help and --version are
// printed here. Errors: whatever the subcommand's are, or an option that is unknown, missing or out of range
// (status 2).
Outcome<int> run_command_line(int argc, char** argv);

}  // namespace game
