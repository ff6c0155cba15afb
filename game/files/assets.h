#pragma once

#include <filesystem>
#include <string_view>
#include <vector>

#include "game/base/outcome.h"

namespace game {

// The folder that holds shaders, scenes, materials and recordings: COULOIR_ASSETS if set, else beside or
// above the program (a build tree), else share/couloir of its prefix (an installation). Errors: none of these
// has it.
Outcome<std::filesystem::path> assets_folder();

enum class AssetKind { kScene, kMaterial, kRecording };

// Names of what ships of a kind, sorted.
Outcome<std::vector<std::string>> asset_names(AssetKind kind);

bool is_asset(AssetKind kind, std::string_view name);

// A shipped thing by its name, or a file by its path. Errors: neither; lists the names there are.
Outcome<std::filesystem::path> find_asset(AssetKind kind, std::string_view name_or_path);

// The shaders and textures that every picture is drawn with.
std::vector<std::filesystem::path> drawing_assets();

}  // namespace game
