#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "game/base/outcome.h"
#include "game/scene/memory.h"
#include "game/scene/scenario.h"
#include "game/scene/shipped_look.h"
#include "terrains/references.h"
#include "terrains/release.h"

namespace game {

// Command-line options that override a scene file.
struct Overrides {
    std::optional<int> squares;           // along the longer side, 8 to 4096
    std::optional<std::string> material;  // name or file
    std::optional<sim::Model> model;
    std::optional<std::string> size_class;  // of the (upper) material
    std::optional<sim::Scheme> scheme;
    std::optional<sim::Law> law;
    // Parameters of the (upper) material, after those of the scene.
    struct Set {
        const sim::ParamInfo* param;
        float value;
    };
    std::vector<Set> set;
    // That of who plays, of week_of(): the seed of the terrain of a scene that is weekly. Others keep the seed of the scene.
    std::optional<std::int64_t> week;
    bool own_grid = false;           // a terrain's own pixels, if `squares` is not given
    std::optional<std::string> crs;  // of a terrain that names none, "EPSG:31287" or WKT
    // Whether a virtual raster may refer to its sources, and a scene to a terrain outside its folder.
    terrains::References references = terrains::References::kRefused;
    LookFrom look = LookFrom::kShipped;  // of a recording
    Memory memory;                       // that the world may take
};

// A scenario and its commands.
struct Scene {
    Scenario scenario;
    std::vector<TimedCommand> commands;             // sorted by tick
    std::vector<std::filesystem::path> files = {};  // that it was read from, sources of a VRT included
    // Of a real hill: what the file of its release states and where it went. Its thickness is in the scenario.
    std::optional<terrains::Release> release = std::nullopt;
    // If they are to be released one at a time: its polygons in the order of the file, and the parameters of the class of each.
    struct Patch {
        terrains::ReleasePatch release;
        sim::Params params;
    };
    std::vector<Patch> patches = {};
    // The class whose friction the material has, and the volume that it was chosen by: none if a person chose it.
    struct Size {
        std::string name;
        std::optional<double> released;  // m³
    };
    std::optional<Size> size = std::nullopt;
    std::vector<std::string> warnings = {};  // of its files, one sentence each, for the user to read
};

// Reads a scene by name or file (docs/scenes.md lists every key), its material and its terrain. Errors:
// damage, with file and line, or a fault of the terrain or the material.
Outcome<Scene> load_scene(std::string_view name_or_path, const Overrides& overrides);

inline constexpr float kDeepestRelease = sim::kDeepest / 2;  // m

// A release to read, and how it is measured (terrains/release.h).
struct ReleaseFile {
    std::filesystem::path path;
    std::optional<terrains::Thickness> measured;
    bool one_at_a_time = false;  // its polygons are Scene::patches too
};

// A scene of a real hill: a DEM, a material (default snow-dry), no cover, borders and no-data as sinks, and
// `release`, if any (raster or GeoJSON, terrains/release.h), as rolling layer at rest.
Outcome<Scene> scene_of_terrain(const std::filesystem::path& dem, const std::optional<ReleaseFile>& release,
                                const Overrides& overrides);

// The same of heights that are given as numbers. Of `terrain`, a name, grid, surface and cover count, and where it has data;
// where it has none, the surface is extended here. `rolling`: a release at rest, m, one value for each vertex.
// Errors, also: a number out of range, with its vertex.
Outcome<Scene> scene_of_heights(terrains::Terrain terrain, std::vector<float> rolling,
                                const Overrides& overrides);

}  // namespace game
