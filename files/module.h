#pragma once

#include <filesystem>

namespace files {

// The folder of the file that this code was linked into: of the program, or of the module that another program, such as
// Python, has loaded. Empty if the system does not say.
std::filesystem::path own_folder();

// Loads a module of this program, lib/couloir/FILE beside own_folder() or above it, and returns the address of `symbol`
// in it. Modules stay loaded. Throws std::runtime_error if the module is missing, because then the installation is
// incomplete.
const void* symbol_of_module(const char* file, const char* symbol);

}  // namespace files
