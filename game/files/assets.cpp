#include "game/files/assets.h"

#include <algorithm>
#include <cstdlib>
#include <initializer_list>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "files/input.h"
#include "files/module.h"
#include "game/files/toml_table.h"

namespace game {
namespace {

namespace fs = std::filesystem;

struct Drawer {
    std::string_view folder, extension, noun;
};

Drawer drawer_of(AssetKind kind) {
    switch (kind) {
        case AssetKind::kScene:
            return {"scenes", ".toml", "scene"};
        case AssetKind::kMaterial:
            return {"materials", ".toml", "material"};
        case AssetKind::kLesson:
            return {"lessons", ".toml", "lesson"};
        case AssetKind::kRecording:
            break;
    }
    return {"recordings", ".couloir", "recording"};
}

}  // namespace

Outcome<fs::path> assets_folder() {
    std::error_code error;
    if (const char* named = std::getenv("COULOIR_ASSETS")) {
        if (fs::is_directory(fs::path(named) / "shaders", error)) return fs::path(named);
        return unusable(fmt::format("COULOIR_ASSETS is {}, which holds no shaders folder", named));
    }
    const fs::path own = files::own_folder();
    for (fs::path above = own; above.has_relative_path(); above = above.parent_path())
        for (const char* place : {"assets", "share/couloir"})
            if (fs::is_directory(above / place / "shaders", error)) return above / place;
    return machine_fails(fmt::format(
        "{}: no assets folder beside the program or above it; set COULOIR_ASSETS to its path", own.string()));
}

Outcome<std::vector<std::string>> asset_names(AssetKind kind) {
    const auto assets = assets_folder();
    if (!assets) return tl::unexpected(assets.error());
    const Drawer drawer = drawer_of(kind);
    std::vector<std::string> names;
    std::error_code error;
    for (const auto& entry : fs::directory_iterator(*assets / drawer.folder, error))
        if (entry.path().extension() == drawer.extension) names.push_back(entry.path().stem().string());
    std::sort(names.begin(), names.end());
    return names;
}

bool is_asset(AssetKind kind, std::string_view name) {
    const auto names = asset_names(kind);
    return names && std::find(names->begin(), names->end(), name) != names->end();
}

std::string asset_title(AssetKind kind, const std::string& name) {
    if (!is_asset(kind, name)) return name;
    const auto document = find_asset(kind, name).and_then(parse_toml);
    return document ? (*document)["title"].value_or(name) : name;
}

tl::unexpected<Failure> unknown_asset(AssetKind kind, std::string_view name) {
    const auto names = asset_names(kind);
    if (!names) return tl::unexpected(names.error());
    return unusable(fmt::format("no {} is named '{}'; there are {}", drawer_of(kind).noun, name,
                                fmt::join(*names, ", ")));
}

Outcome<fs::path> find_asset(AssetKind kind, std::string_view name_or_path) {
    const fs::path given(name_or_path);
    std::error_code error;
    const Drawer drawer = drawer_of(kind);
    const bool is_path = given.has_parent_path() || given.has_extension();
    // Shipped assets come first: a folder or file of the same name must not hide them.
    if (!is_path && is_asset(kind, name_or_path))
        return *assets_folder() / drawer.folder / fmt::format("{}{}", name_or_path, drawer.extension);
    const auto is_file = files::check_input(given);
    if (is_file) return given;
    if (is_path || fs::exists(given, error)) return unusable(is_file.error());
    return unknown_asset(kind, name_or_path);
}

namespace {

std::vector<fs::path> files_below(std::initializer_list<const char*> folders) {
    std::vector<fs::path> files;
    const auto assets = assets_folder();
    if (!assets) return files;
    std::error_code error;
    for (const char* folder : folders)
        for (const auto& entry : fs::recursive_directory_iterator(*assets / folder, error))
            if (entry.is_regular_file(error)) files.push_back(entry.path());
    return files;
}

}  // namespace

std::vector<fs::path> drawing_assets() {
    return files_below({"shaders", "textures"});
}

std::vector<fs::path> page_assets() {
    return files_below({"shaders", "textures", "web"});
}

}  // namespace game
