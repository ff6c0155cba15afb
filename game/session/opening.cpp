#include "game/session/opening.h"

#include <filesystem>

#include <fmt/format.h>

#include "game/files/assets.h"

namespace game {
namespace {

namespace fs = std::filesystem;

Outcome<Opening> open_scene(const std::string& name_or_path, const Wishes& wishes) {
    auto scene = load_scene(name_or_path, wishes);
    if (!scene) return tl::unexpected(scene.error());
    std::string told = fmt::format("Loaded {}", scene->start.title);
    return Opening{std::move(*scene), {}, std::nullopt, std::move(told), wishes.memory};
}

Outcome<Opening> open_recording(const fs::path& path, const Memory& memory) {
    std::error_code error;
    const bool is_file = fs::exists(path, error);
    const auto found = is_file || path.has_parent_path()
                           ? Outcome<fs::path>(path)
                           : find_asset(AssetKind::kRecording, path.stem().string());
    if (!found) return tl::unexpected(found.error());
    auto recording = read_recording(*found, memory);
    if (!recording) return tl::unexpected(recording.error());
    Opening opening;
    opening.memory = memory;
    opening.name = found->stem().string();
    opening.scene.start = recording->header.start;
    opening.scene.commands = recording->commands;
    opening.scene.files = {*found};
    opening.told = recording->warning.value_or(fmt::format("Watching {}", found->filename().string()));
    opening.watched = std::move(*recording);
    return opening;
}

Outcome<Opening> open_terrain(const fs::path& path, const Wishes& wishes) {
    auto scene = scene_of_terrain(path, std::nullopt, wishes);
    if (!scene) return tl::unexpected(scene.error());
    const sim::Grid& grid = scene->start.grid;
    std::string told = fmt::format("Loaded {}: {} by {} squares of {:.1f} m", path.filename().string(),
                                   grid.nx - 1, grid.ny - 1, grid.dx);
    return Opening{std::move(*scene), {}, std::nullopt, std::move(told), wishes.memory};
}

}  // namespace

Outcome<Opening> open_anything(const std::string& name_or_path, const Wishes& wishes) {
    const fs::path path(name_or_path);
    if (path.extension() == ".couloir") return open_recording(path, wishes.memory);
    std::error_code error;
    const bool is_raster =
        path.extension() != ".toml" && fs::exists(path, error) && !is_asset(AssetKind::kScene, name_or_path);
    return is_raster ? open_terrain(path, wishes) : open_scene(name_or_path, wishes);
}

}  // namespace game
