#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "game/base/outcome.h"
#include "game/files/toml_table.h"
#include "game/scene/camera_key.h"

namespace game {

// Reads the keys of [camera], which a row of [[camera_path]] has too. The caller finishes the table.
render::Camera read_camera(TomlTable& table);

// Reads the rows [[camera_path]] of a scene: none, or kFewestCameraKeys to kMostCameraKeys, each later than the one before.
std::vector<CameraKey> read_camera_path(TomlTable& root);

// Reads a file that has such rows and nothing else. Errors (status 2): it cannot be read or is no such file, with its line.
Outcome<std::vector<CameraKey>> load_camera_path(const std::filesystem::path& file);

// The text of such a file, which load_camera_path() reads bit-identical.
std::string camera_path_text(std::span<const CameraKey> keys);

}  // namespace game
