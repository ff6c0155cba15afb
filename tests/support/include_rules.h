#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

// The dependencies between the rooms, from #include lines:
//
//   files/     ──► standard headers and those of the system
//   sim/       ──► standard headers without files and clock; GLM, xxHash
//   terrains/  ──► files; sim's grid; GDAL, OpenImageIO, GeographicLib, JSON (for GeoJSON)
//   render/    ──► files; sim; GLM, epoxy, EGL, OpenImageIO; the headers that C++ shares with shaders
//   game/      ──► all four and any library
//   tests/     ──► anything
//
// Two libraries belong to one file each: GLFW to game/app/window.cpp, CLI11 to game/command_line.cpp.
// Anything not listed for a room is forbidden there, so a new library needs a line here.
namespace support {

// An include that breaks the rules.
struct Breach {
    std::string file;  // "sim/step.cpp"
    int line = 0;      // from 1
    std::string fact;  // "sim may not include <fstream>"
};

// One #include line.
struct Include {
    int line = 0;        // from 1
    std::string header;  // "sim/core/grid.h", or a library's name as written; empty if a macro names it
};

// Returns the includes of one source text, in order, read as the preprocessor does, except that those disabled
// by #if count too. Our own headers get their path from the top of the checkout.
std::vector<Include> includes_of(std::string_view file, std::string_view text);

// Returns the violations in one source text. `file` is its path from the top of the checkout and begins with
// its room. A name from a macro is a violation.
std::vector<Breach> breaches_in(std::string_view file, std::string_view text);

// The C++ files of the rooms under `top`, as paths from there, sorted.
std::vector<std::filesystem::path> sources_of(const std::filesystem::path& top);

}  // namespace support
