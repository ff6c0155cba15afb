#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "game/base/outcome.h"

namespace game {

// The folder with shaders, scenes, materials and recordings: COULOIR_ASSETS if set, else beside or above the
// program (a build tree), else share/couloir of its prefix (an installation). Errors: none of these has them.
Outcome<std::filesystem::path> assets_folder();

enum class AssetKind { kScene, kMaterial, kRecording, kLesson };

// Names of all shipped assets of a kind, sorted.
Outcome<std::vector<std::string>> asset_names(AssetKind kind);

bool is_asset(AssetKind kind, std::string_view name);

// The title in a shipped TOML file; its name if it has none, or there is no such asset.
std::string asset_title(AssetKind kind, const std::string& name);

// The error for a name that no shipped asset has: it lists the names there are.
tl::unexpected<Failure> unknown_asset(AssetKind kind, std::string_view name);

// Finds a shipped asset by its name, or a file by its path. Errors: neither; lists the known names.
Outcome<std::filesystem::path> find_asset(AssetKind kind, std::string_view name_or_path);

// The shaders and textures that every frame is drawn with.
std::vector<std::filesystem::path> drawing_assets();
// Those that a slide's page is made of.
std::vector<std::filesystem::path> page_assets();

}  // namespace game
