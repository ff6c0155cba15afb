#pragma once

#include <filesystem>
#include <string>
#include <vector>

// docs/architecture.svg: the rooms of the program, drawn from the #include lines of its sources, and the ways
// of a grain and of a command through them.
namespace architecture {

struct Picture {
    std::string svg;                  // whole file, the same bytes for the same includes
    std::vector<std::string> faults;  // why the picture would be wrong or unreadable; empty if it is neither
};

// Draws the checkout at `top`. An arrow means "includes" and goes down. Arrows that follow from others are left
// out. A new room needs a line in kRooms (architecture.cpp): its column and its duty.
Picture draw(const std::filesystem::path& top);

}  // namespace architecture
