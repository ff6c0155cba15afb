#include "game/scene/camera_keys.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "game/base/limits.h"
#include "game/scene/shown_numbers.h"

namespace game {

render::Camera read_camera(TomlTable& table) {
    render::Camera camera;
    const auto target = table.numbers("target", 3);
    if (target) camera.target = {(*target)[0], (*target)[1], (*target)[2]};
    if (!target) table.blame("", "needs a target: metres east, north and up");
    if (target && std::ranges::any_of(*target, [](double at) { return std::abs(at) > kFarthestTarget; }))
        table.blame("target", fmt::format("is farther away than {:.0f} m", kFarthestTarget));
    table.numbers(kCameraNumbers, camera);
    return camera;
}

std::vector<CameraKey> read_camera_path(TomlTable& root) {
    std::vector<CameraKey> keys;
    if (!root.has("camera_path")) return keys;
    std::vector<TomlTable> rows = root.tables("camera_path");
    if (rows.size() < kFewestCameraKeys || rows.size() > kMostCameraKeys)
        root.blame("camera_path", fmt::format("has {} rows; {} to {} are allowed", rows.size(),
                                              kFewestCameraKeys, kMostCameraKeys));
    for (TomlTable& row : rows) {
        const auto time = row.number("time", 0, CameraKey::kLatest);
        if (!time) row.blame("", "needs a time, in seconds");
        if (time && !keys.empty() && *time <= keys.back().time_s)
            row.blame("time", "is not later than that of the row before");
        keys.push_back({time.value_or(0), read_camera(row)});
        row.finish();
    }
    return keys;
}

Outcome<std::vector<CameraKey>> load_camera_path(const std::filesystem::path& file) {
    const auto document = parse_toml(file);
    if (!document) return tl::unexpected(document.error());
    TomlFault fault;
    TomlTable root(*document, "", file.string(), fault);
    auto keys = read_camera_path(root);
    root.finish();
    if (fault) return unusable(*fault);
    if (keys.empty())
        return unusable(
            fmt::format("{}: has no rows [[camera_path]], so it is no camera path", file.string()));
    return keys;
}

std::string camera_path_text(std::span<const CameraKey> keys) {
    std::string text = "# A camera path, in s, m and degrees: docs/film.md\n";
    for (const CameraKey& key : keys) {
        const render::Camera& camera = key.camera;
        text += fmt::format("\n[[camera_path]]\ntime = {}\ntarget = [{}, {}, {}]\n", key.time_s,
                            camera.target.x, camera.target.y, camera.target.z);
        for (const auto& number : kCameraNumbers)
            text += fmt::format("{} = {}\n", number.in_scene, camera.*number.value);
    }
    return text;
}

}  // namespace game
