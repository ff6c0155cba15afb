#pragma once

namespace files {

// Loads a module of this program, ../lib/couloir/FILE relative to the program's folder, and returns the
// address of `symbol` in it. Modules stay loaded. Throws std::runtime_error if the module is missing, because
// then the installation is incomplete.
const void* symbol_of_module(const char* file, const char* symbol);

}  // namespace files
