#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "game/base/outcome.h"
#include "game/scene/memory.h"
#include "game/scene/scenario.h"
#include "terrains/references.h"

namespace game {

// What a person may say on the command line against what a scene file says.
struct Overrides {
    std::optional<int> squares;           // along the longer side, 8 to 4096
    std::optional<std::string> material;  // name or file
    std::optional<sim::Model> model;
    std::optional<sim::Scheme> scheme;
    std::optional<sim::Law> law;
    // Of virtual rasters to their sources, and of a scene to a terrain outside its folder.
    terrains::References references = terrains::References::kRefused;
    Memory memory;  // what the world may take
};

// A start, and what is done to it at which tick.
struct Scene {
    Scenario scenario;
    std::vector<TimedCommand> commands;             // in order of their ticks
    std::vector<std::filesystem::path> files = {};  // that it was read from
};

// Reads a scene by name or file (README.md has every key), its material and its terrain. Errors: damage, told
// with file and line, or whatever is wrong with terrain or material.
Outcome<Scene> load_scene(std::string_view name_or_path, const Overrides& overrides);

// A real hill without a scene: a DEM, the material (snow-dry unless wished otherwise), no cover, borders and
// no-data as sinks, and `release`, if any, (raster or GeoJSON, terrains/release.h) as rolling layer at rest.
Outcome<Scene> scene_of_terrain(const std::filesystem::path& dem,
                                const std::optional<std::filesystem::path>& release,
                                const Overrides& overrides);

}  // namespace game
