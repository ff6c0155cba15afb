#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include <toml++/toml.h>

#include "game/base/outcome.h"

namespace game {

// A scene as written, with what it takes over from another one.
struct SceneFile {
    toml::table document;
    std::vector<std::filesystem::path> files;  // that it was read from, its own first
    // The challenge that this one is harder than, and has all tables and keys of but those that it states itself.
    std::optional<std::string> harder_than;
};

// Errors: a file cannot be read or is not TOML; or what it is harder than is neither a scene that ships nor a file in its
// folder, is no challenge, or is harder than another one itself.
Outcome<SceneFile> read_scene_file(const std::filesystem::path& file);

}  // namespace game
