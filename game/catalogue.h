#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "game/outcome.h"

namespace game {

// What ships, by name and title, for whoever offers a choice. Read once.
struct Catalogue {
    struct Entry {
        std::string name, title;
        std::filesystem::path file;  // a scene and a recording may share a name
    };
    std::vector<Entry> scenes, materials, recordings;
};

// Errors: the assets cannot be found or one of them cannot be read.
Outcome<Catalogue> read_catalogue();

}  // namespace game
