#include "files/module.h"

#include <dlfcn.h>

#include <filesystem>
#include <stdexcept>

#include <fmt/format.h>

namespace files {

const void* symbol_of_module(const char* file, const char* symbol) {
    namespace fs = std::filesystem;
    std::error_code error;
    const fs::path program = fs::read_symlink("/proc/self/exe", error);
    const fs::path module = program.parent_path().parent_path() / "lib" / "couloir" / file;
    void* library = dlopen(module.c_str(), RTLD_NOW | RTLD_LOCAL);
    const void* found = library == nullptr ? nullptr : dlsym(library, symbol);
    if (found == nullptr)
        throw std::runtime_error(
            fmt::format("a module of the program cannot be loaded; reinstall the program ({})", dlerror()));
    return found;
}

}  // namespace files
