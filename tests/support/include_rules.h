#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

// The arrows between the rooms of the house, read off #include lines:
//
//   files/     ──► standard headers and those of the system
//   sim/       ──► standard headers without files and clock; GLM, xxHash
//   terrains/  ──► files; sim's grid; GDAL, OpenImageIO, GeographicLib, JSON (for GeoJSON)
//   render/    ──► files; sim; GLM, epoxy, EGL, OpenImageIO; the headers that C++ shares with shaders
//   game/      ──► all four and any library
//   tests/     ──► anything
//
// Two libraries are one file's alone: GLFW game/app/window.cpp's, CLI11 game/command_line.cpp's.
// Everything not listed for a room is against the rules there, so that a new library is a line here.
namespace support {

// An include that breaks the rules.
struct Breach {
    std::string file;  // "sim/step.cpp"
    int line = 0;      // from 1
    std::string fact;  // "sim may not include <fstream>"
};

// Breaches of one source text. `file` is its path from the top of the checkout and begins with its room. Sees
// includes as the preprocessor would but for two things: it takes those that are switched off by #if for
// real, and calls a name that a macro would give a breach.
std::vector<Breach> breaches_in(std::string_view file, std::string_view text);

// The C++ files of the rooms under `top`, as paths from there, sorted.
std::vector<std::filesystem::path> sources_of(const std::filesystem::path& top);

}  // namespace support
