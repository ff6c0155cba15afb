#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <toml++/toml.h>

#include "game/base/outcome.h"

namespace game {

// A scene as written, with what it takes over from another one.
struct SceneFile {
    toml::table document;
    std::vector<std::filesystem::path> files;  // that it was read from, its own first
    // The challenge that this one is harder than, and has all tables and keys of but those that it states itself.
    std::optional<std::string> harder_than = {};
    // For a person who chooses among scenes; the document has neither. How hard a challenge is: 1, easy, to kHardest;
    // of a harder one that does not state it, one more than of the other.
    static constexpr std::int64_t kHardest = 4;
    static constexpr std::size_t kMostAbout = 200;  // bytes
    std::optional<std::string> about = {};
    std::optional<std::int64_t> difficulty = {};
    bool weekly = false;  // Overrides::week is the seed of its terrain
};

// Errors: a file cannot be read or is not TOML; or what it is harder than is neither a scene that ships nor a file in its
// folder, is no challenge, or is harder than another one itself; or `about` or `difficulty` is out of range.
Outcome<SceneFile> read_scene_file(const std::filesystem::path& file);

}  // namespace game
