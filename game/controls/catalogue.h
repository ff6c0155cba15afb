#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "game/base/outcome.h"

namespace game {

// What there is to begin with, by name and title, for whoever offers a choice.
struct Catalogue {
    struct Entry {
        std::string name, title;
        std::filesystem::path file;  // a scene and a recording may share a name
    };
    std::vector<Entry> scenes, materials, recordings;
    std::vector<Entry> own;  // recordings that the person has made, the newest first
};

// All but `own`. Errors: the assets cannot be found or one of them cannot be read.
Outcome<Catalogue> read_catalogue();

// The newest of the recordings folder, kMostOwn at most; none where there is no such folder.
inline constexpr std::size_t kMostOwn = 8;
std::vector<Catalogue::Entry> own_recordings();

}  // namespace game
