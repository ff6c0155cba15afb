#pragma once

namespace files {

// Loads a part of this program that is a library of its own, ../lib/couloir/FILE seen from the program's
// folder, and returns the address of `symbol` in it. Loaded libraries stay. Throws std::runtime_error if
// there is no such part, because then the program is not installed whole.
const void* symbol_of_module(const char* file, const char* symbol);

}  // namespace files
