#pragma once

#include "game/base/outcome.h"

namespace game {

// Parses the command line, runs the subcommand it names and returns its exit status. Prints --help and
// --version. Errors: those of the subcommand, or an option that is unknown, missing or out of range (status
// 2).
Outcome<int> run_command_line(int argc, char** argv);

}  // namespace game
