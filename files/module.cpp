#include "files/module.h"

#include <dlfcn.h>
#include <link.h>

#include <stdexcept>

#include <fmt/format.h>

namespace files {
namespace {

namespace fs = std::filesystem;

// The first that exists; else the one beside the program, for the message.
fs::path place_of(const char* file) {
    std::error_code error;
    const fs::path here = own_folder();
    for (fs::path above = here; above.has_relative_path(); above = above.parent_path())
        if (fs::path found = above / "lib" / "couloir" / file; fs::exists(found, error)) return found;
    return here.parent_path() / "lib" / "couloir" / file;
}

}  // namespace

fs::path own_folder() {
    Dl_info info;
    link_map* map = nullptr;
    std::error_code error;
    const bool is_known = dladdr1(reinterpret_cast<const void*>(&own_folder), &info,
                                  reinterpret_cast<void**>(&map), RTLD_DL_LINKMAP) != 0;
    // The program itself has no name there, or the one by which it was called.
    const bool is_program = !is_known || map == nullptr || map->l_name[0] == '\0';
    return (is_program ? fs::read_symlink("/proc/self/exe", error) : fs::canonical(map->l_name, error))
        .parent_path();
}

const void* symbol_of_module(const char* file, const char* symbol) {
    void* library = dlopen(place_of(file).c_str(), RTLD_NOW | RTLD_LOCAL);
    const void* found = library == nullptr ? nullptr : dlsym(library, symbol);
    if (found == nullptr)
        throw std::runtime_error(
            fmt::format("a module of the program cannot be loaded; reinstall the program ({})", dlerror()));
    return found;
}

}  // namespace files
