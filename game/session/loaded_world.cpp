#include "game/session/loaded_world.h"

#include <algorithm>
#include <cmath>
#include <filesystem>

#include <fmt/format.h>

#include "game/files/assets.h"
#include "game/files/text_file.h"
#include "game/recording/recording_file.h"
#include "game/scene/goal_reach.h"
#include "game/words/words.h"
#include "terrains/geojson.h"

namespace game {
namespace {

namespace fs = std::filesystem;

std::string warnings_of(const Scene& scene) {
    std::string text;
    for (const std::string& warning : scene.warnings) text += ". " + warning;
    return text;
}

Outcome<LoadedWorld> open_scene(const std::string& name_or_path, const Overrides& overrides) {
    auto scene = load_scene(name_or_path, overrides);
    if (!scene) return tl::unexpected(scene.error());
    std::string told = fmt::format("Loaded {}", scene->scenario.title) + warnings_of(*scene);
    return LoadedWorld{std::move(*scene), {}, std::nullopt, std::move(told), overrides.memory};
}

Outcome<LoadedWorld> open_recording(const fs::path& path, const Overrides& overrides) {
    std::error_code error;
    const bool is_file = fs::exists(path, error);
    const auto found = is_file || path.has_parent_path()
                           ? Outcome<fs::path>(path)
                           : find_asset(AssetKind::kRecording, path.stem().string());
    if (!found) return tl::unexpected(found.error());
    auto recording = read_recording(*found, overrides.memory);
    if (!recording) return tl::unexpected(recording.error());
    LoadedWorld loaded;
    loaded.memory = overrides.memory;
    loaded.name = found->stem().string();
    loaded.scene.scenario = recording->header.scenario;
    if (auto taken = take_look(overrides.look, loaded.scene.scenario); !taken)
        return tl::unexpected(taken.error());
    loaded.scene.files = {*found};
    if (is_world(*recording)) {
        Scenario& world = loaded.scene.scenario;
        if (!world.goal) world.scene = loaded.name;  // what is recorded in it is named by that
        if (world.goal) {
            if (const auto wrong = fault_of_reach(world))
                return unusable(fmt::format("{}: the goal: {}", found->string(), to_text(*wrong)));
            loaded.scene.commands = world.goal->events;
        }
        loaded.told = recording->warning.value_or(fmt::format("Loaded {}", found->filename().string()));
        return loaded;
    }
    loaded.scene.commands = recording->commands;
    loaded.told = recording->warning.value_or(fmt::format("Watching {}", found->filename().string()));
    loaded.watched = std::move(*recording);
    return loaded;
}

Outcome<LoadedWorld> open_terrain(const fs::path& path, const Overrides& overrides) {
    if (terrains::looks_like_json(path))
        return unusable(
            fmt::format("{}: polygons are no terrain; a release is given with its hill: couloir run "
                        "--terrain DEM --release {}",
                        path.string(), path.filename().string()));
    auto scene = scene_of_terrain(path, std::nullopt, overrides);
    if (!scene) return tl::unexpected(scene.error());
    const sim::Grid& grid = scene->scenario.grid;
    std::string told = fmt::format("Loaded {}: {} by {} squares of {:.1f} m", path.filename().string(),
                                   grid.nx - 1, grid.ny - 1, grid.dx);
    scene->scenario.trees = woods_of_hill(scene->scenario);
    told += fmt::format(". Its woods, below {:.0f} m, are for the eye", scene->scenario.trees.line_m);
    told += warnings_of(*scene);
    return LoadedWorld{std::move(*scene), {}, std::nullopt, std::move(told), overrides.memory};
}

}  // namespace

render::TreeRules woods_of_hill(const Scenario& scenario) {
    constexpr double kDensity = 250;  // trees per hectare
    constexpr double kMostAsked =
        250000;  // trees on the grid if all of it were wooded: far more would not be drawn
    constexpr double kAlps = 47, kLine = 2000, kFall = 72;  // degrees; m; m per degree toward the pole
    constexpr double kLowest = 0, kHighest = 3900;          // m
    render::TreeRules rules;
    const sim::Grid& grid = scenario.grid;
    const double east = (grid.nx - 1) * static_cast<double>(grid.dx),
                 north = (grid.ny - 1) * static_cast<double>(grid.dx), hectares = east * north / 1e4;
    rules.density = std::min(kDensity, kMostAsked / hectares);
    if (const auto place = scenario.georeference.to_lat_lon({east / 2, north / 2}))
        rules.line_m = std::clamp(kLine - kFall * (std::abs(place->latitude) - kAlps), kLowest, kHighest);
    return rules;
}

Outcome<std::string> watched_text(const LoadedWorld& world) {
    if (!world.watched || world.scene.files.empty()) return unusable("nothing is watched");
    return read_text(world.scene.files.front());
}

bool is_world(const Recording& recording) {
    return recording.end == 0 && recording.commands.empty();
}

Outcome<LoadedWorld> open_lesson(const std::string& name_or_path, const Overrides& overrides) {
    const auto file = find_asset(AssetKind::kLesson, name_or_path);
    if (!file) return tl::unexpected(file.error());
    auto lesson = read_lesson(*file);
    if (!lesson) return tl::unexpected(lesson.error());
    const auto wrong = [&](int line, const std::string& fact) {
        return unusable(fmt::format("{}:{}: {}", file->string(), line, fact));
    };
    auto loaded = open_recording(lesson->recording, overrides);
    if (!loaded) return wrong(lesson->recording_line, "recording: " + loaded.error().sentence);
    if (!loaded->watched) return wrong(lesson->recording_line, "recording has nothing to watch");
    const Scenario& scenario = loaded->scene.scenario;
    const double tick_s = static_cast<double>(scenario.params.tick_s), dx = scenario.grid.dx,
                 end_s = static_cast<double>(loaded->watched->last_tick()) * tick_s;
    const double east = (scenario.grid.nx - 1) * dx, north = (scenario.grid.ny - 1) * dx;
    for (const Lesson::Stop& stop : lesson->stops) {
        if (stop.time_s > end_s + tick_s / 2)
            return wrong(stop.line, fmt::format("stop.time is {}, after the end of the recording at {:.2f} s",
                                                stop.time_s, end_s));
        if (stop.camera && (stop.camera->east > east || stop.camera->north > north))
            return wrong(stop.line, fmt::format("stop.camera looks at a place outside the terrain of {:g} by "
                                                "{:g} m",
                                                east, north));
    }
    loaded->scene.files.push_back(*file);
    loaded->told = loaded->watched->warning.value_or(said("Lesson: {}", tr(lesson->title.c_str())));
    loaded->lesson = std::move(*lesson);
    return loaded;
}

Outcome<LoadedWorld> open_anything(const std::string& name_or_path, const Overrides& overrides) {
    const fs::path path(name_or_path);
    if (path.extension() == ".toml" && is_lesson(path)) return open_lesson(name_or_path, overrides);
    if (path.extension() == ".couloir") return open_recording(path, overrides);
    std::error_code error;
    const bool is_raster =
        path.extension() != ".toml" && fs::exists(path, error) && !is_asset(AssetKind::kScene, name_or_path);
    return is_raster ? open_terrain(path, overrides) : open_scene(name_or_path, overrides);
}

}  // namespace game
