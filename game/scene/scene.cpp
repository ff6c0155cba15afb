#include "game/scene/scene.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <span>

#include <fmt/format.h>

#include "files/input.h"
#include "game/files/assets.h"
#include "game/files/toml_table.h"
#include "game/scene/camera_keys.h"
#include "game/scene/date.h"
#include "game/scene/flow_scene.h"
#include "game/scene/goal_reach.h"
#include "game/scene/material.h"
#include "game/scene/poured_beside.h"
#include "game/scene/scene_commands.h"
#include "game/scene/scene_file.h"
#include "game/scene/scene_goal.h"
#include "game/scene/scene_ground.h"
#include "game/scene/scene_light.h"
#include "game/scene/scene_things.h"
#include "game/scene/scene_trees.h"
#include "game/scene/scene_weather.h"
#include "game/scene/shown_numbers.h"
#include "game/scene/standing.h"
#include "render/mountain/overview.h"
#include "terrains/dem_gdal.h"
#include "terrains/limits.h"
#include "terrains/release.h"
#include "terrains/resample.h"

namespace game {
namespace {

namespace fs = std::filesystem;
using terrains::Terrain;

void read_borders(TomlTable& physics, sim::Params& params) {
    const auto name = physics.text("borders");
    if (!name) return;
    if (const auto border = sim::border_from(*name))
        params.borders.fill(*border);
    else
        physics.blame("borders", "is not one of wall, open, sink");
}

sim::Model read_model(TomlTable& physics, const Overrides& overrides) {
    const auto name = physics.text("model");
    const auto model = name ? sim::model_from(*name) : sim::Model::kBcreInertial;
    if (!model) physics.blame("model", "is not one of bcre, bcre-inertial, voellmy");
    return overrides.model.value_or(model.value_or(sim::Model::kBcreInertial));
}

void take_choices(const Overrides& overrides, sim::Params& params) {
    params.scheme = overrides.scheme.value_or(params.scheme);
    params.law = overrides.law.value_or(params.law);
}

Outcome<void> take_set(const Overrides& overrides, sim::Params& params) {
    for (const Overrides::Set& each : overrides.set) {
        if (!sim::is_used_by(*each.param, params.model))
            return unusable(fmt::format("--set {}: the model {} does not use it", each.param->name,
                                        sim::to_string(params.model)));
        params.*each.param->value = each.value;
    }
    if (overrides.set.empty()) return {};
    if (const auto wrong = sim::fault_of(params)) return unusable(fmt::format("--set: {}", *wrong));
    return {};
}

// Reads the scheme and the velocity law of bcre.
void read_choices(TomlTable& physics, const Overrides& overrides, sim::Params& params) {
    if (const auto name = physics.text("scheme")) {
        const auto scheme = sim::scheme_from(*name);
        if (!scheme) physics.blame("scheme", "is not one of lax-friedrichs, local-lax-friedrichs, muscl");
        params.scheme = scheme.value_or(params.scheme);
    }
    if (const auto name = physics.text("law")) {
        const auto law = sim::law_from(*name);
        if (!law) physics.blame("law", "is not one of constant, slope, shear");
        params.law = law.value_or(params.law);
    }
    take_choices(overrides, params);
}

// Terrain without a view of its own is seen from the valley, with the sun low and beside the slope, on its southern
// side, because that shows its shape.
void view_from_valley(Scenario& scenario) {
    const sim::State state = sim::make_state(initial_state_of(scenario), scenario.params);
    scenario.camera = render::landscape_view(sim::view(state));
    constexpr double kBeside = 70, kHeight = 24;  // degrees
    const double from = scenario.camera->azimuth_deg;
    const double southward = std::remainder(180 - from, 360);
    scenario.light = {std::fmod(from + std::copysign(kBeside, southward) + 360, 360), kHeight};
}

// Reads [wind].
void read_wind(TomlTable& table, render::Wind& wind) {
    if (!table.has("from")) table.blame("", "needs `from`, in degrees");
    if (!table.has("speed")) table.blame("", "needs a speed, in m/s");
    table.numbers(kWindNumbers, wind);
    table.finish();
}

// Reads [look], [camera], [[camera_path]] and [light]. Returns the moment whose sun lights the scene, if [light] gives one.
std::optional<SunMoment> read_view(TomlTable& root, Scenario& scenario) {
    if (auto table = root.table("look")) {
        if (const auto style = table->text("style")) {
            if (*style != "landscape" && *style != "model")
                table->blame("style", "is neither landscape nor model");
            scenario.model = *style == "model";
        }
        if (const auto date = table->text("date")) {
            scenario.look.date = date_from(*date);
            if (!scenario.look.date)
                table->blame("date", "is no day of a year; write month and day, such as \"07-15\"");
        }
        table->finish();
    }
    if (auto table = root.table("camera")) {
        scenario.camera = read_camera(*table);
        table->finish();
    }
    scenario.camera_path = read_camera_path(root);
    if (auto table = root.table("light")) return read_light(*table, scenario.light);
    return std::nullopt;
}

void light_by(const std::optional<SunMoment>& moment, TomlTable& root, Scenario& scenario) {
    if (moment && !set_sun(*moment, scenario))
        root.blame(
            "light",
            "needs latitude and longitude beside time, because the terrain's place on Earth is unknown");
}

Outcome<void> check_choices(const Overrides& overrides, sim::Model model) {
    if ((!overrides.scheme && !overrides.law) || model == sim::Model::kBcre) return {};
    return unusable(fmt::format("--{} applies only to the model bcre, and this is {}; add --model bcre",
                                overrides.scheme ? "scheme" : "law", sim::to_string(model)));
}

void add_files(const std::vector<fs::path>& files, Scene& scene) {
    scene.files.insert(scene.files.end(), files.begin(), files.end());
}

void take_lower(Scenario& scenario, const Material& lower) {
    scenario.lower = Scenario::Lower{lower.name, lower.params, {}, lower.density, {}, {}};
    sim::take_choices(scenario.params, scenario.lower->params);
    take_look_of_lower(lower.look, scenario.look);
}

void take_material(Scenario& scenario, const Material& material, const sim::Params& over) {
    scenario.material = material.name;
    scenario.density = material.density;
    scenario.look = material.look;
    scenario.params = over;
}

// The parameters of a material: of the class that was asked for, or of that of the released volume, m³, if it is known.
// Errors: the material has no such class.
Outcome<sim::Params> params_of(const Material& material, const Overrides& overrides,
                               std::optional<double> released, Scene& scene) {
    const SizeClass* size = released ? size_of(material, *released) : nullptr;
    if (overrides.size_class) {
        const auto found = std::ranges::find(material.sizes, *overrides.size_class, &SizeClass::name);
        if (found == material.sizes.end()) {
            std::vector<std::string> names;
            for (const SizeClass& each : material.sizes) names.push_back(each.name);
            return unusable(
                fmt::format("--size-class {}: {} has {}", *overrides.size_class, material.name,
                            names.empty() ? "no classes" : fmt::format("{}", fmt::join(names, ", "))));
        }
        size = &*found, released.reset();
    }
    if (!size) return material.params;
    scene.size = Scene::Size{size->name, released};
    return size->params;
}

// A material that a scene names: a shipped one, or a file beside or below the scene, as terrain is. Errors,
// without the place: it may not or cannot be read.
Outcome<Material> material_of_scene(const std::string& name, const fs::path& folder,
                                    terrains::References references, sim::Model model) {
    const bool is_shipped = is_asset(AssetKind::kMaterial, name);
    const fs::path file = folder / name;
    if (!is_shipped && references != terrains::References::kAllowed && !files::is_within(folder, file))
        return unusable("lies outside the scene's folder; add --allow-references if you trust the scene");
    std::error_code error;
    const bool is_name = !fs::path(name).has_parent_path() && !fs::path(name).has_extension();
    if (!is_shipped && is_name && !fs::exists(file, error))
        return unusable("cannot be used: " + unknown_asset(AssetKind::kMaterial, name).value().sentence);
    auto material = load_material(is_shipped ? name : file.string(), model);
    if (!material) return unusable("cannot be used: " + material.error().sentence);
    return material;
}

// Reads the whole file in the order of its dependencies. Faults
// are collected in `fault`; the result is then meaningless.
Outcome<Scene> read_scene(TomlTable& root, const SceneFile& file, const Overrides& overrides,
                          TomlFault& fault) {
    const fs::path& path = file.files.front();
    Scene scene;
    Scenario& scenario = scene.scenario;
    const fs::path folder = path.parent_path();
    scene.files = file.files;
    scenario.scene = path.stem().string();
    scenario.title = root.text("title").value_or(scenario.scene);

    if (auto flow = root.table("flow")) {
        if (auto read = read_flow(*flow, overrides, scenario); !read) return tl::unexpected(read.error());
        light_by(read_view(root, scenario), root, scenario);
        root.finish();
        if (fault) return unusable(*fault);
        return scene;
    }

    auto cover = root.table("cover");
    auto under = root.table("under");
    auto physics = root.table("physics");
    auto ground = root.table("terrain");
    if (!cover) root.blame("", "has no [cover]");
    if (!physics) root.blame("", "has no [physics]");
    if (!ground) root.blame("", "has no [terrain]");
    if (fault) return unusable(*fault);

    const auto named = cover->text("material");
    if (!named) cover->blame("", "needs a material");
    const auto rule = read_cover_rule(*cover);
    cover->finish();
    const auto under_named = under ? under->text("material") : std::nullopt;
    const auto under_rule = under ? read_cover_rule(*under) : std::nullopt;
    if (under && !under_named) under->blame("", "needs a material");
    if (under && !under_rule) under->blame("", "needs a depth, in metres");
    const sim::Model model = read_model(*physics, overrides);
    if (fault) return unusable(*fault);
    if (const auto sound = check_choices(overrides, model); !sound) return tl::unexpected(sound.error());

    const auto material = overrides.material ? load_material(*overrides.material, model)
                                             : material_of_scene(*named, folder, overrides.references, model);
    if (!material && !overrides.material) cover->blame("material", material.error().sentence);
    if (!material) return fault ? unusable(*fault) : tl::unexpected(material.error());
    scene.files.push_back(material->file);
    auto of_material = params_of(*material, overrides, std::nullopt, scene);
    if (!of_material) return tl::unexpected(of_material.error());
    sim::Params params = *of_material;
    read_choices(*physics, overrides, params);
    read_borders(*physics, params);
    // A scene's own parameters are for its own model; with another model the material's apply.
    sim::Params unused;
    const auto own_name = physics->text("model");
    const sim::Model own = own_name ? *sim::model_from(*own_name) : sim::Model::kBcreInertial;
    read_physics_numbers(*physics, own, own == model ? params : unused);
    physics->finish();
    if (const auto set = take_set(overrides, params); !set) return tl::unexpected(set.error());
    take_material(scenario, *material, params);
    if (under_rule) {
        const auto lower = material_of_scene(*under_named, folder, overrides.references, model);
        if (!lower) under->blame("material", lower.error().sentence);
        if (!lower) return unusable(*fault);
        scene.files.push_back(lower->file);
        take_lower(scenario, *lower);
        read_physics_numbers(*under, own, own == model ? scenario.lower->params : unused);
        if (const auto wrong = sim::fault_of(scenario.lower->params)) under->blame("", *wrong);
    }
    if (under) under->finish();
    TreesTable trees;
    if (auto table = root.table("trees")) trees = read_trees(*table, folder, overrides.references);
    ThingsTables things = read_things(root);
    if (auto wind = root.table("wind")) read_wind(*wind, scenario.wind);
    auto weather = root.table("weather");
    const bool woods_act = trees.rules.density > 0;
    scene.commands = read_commands(root, params.tick_s, scenario.lower.has_value());
    if (weather) scenario.weather = read_weather(*weather, scenario, scene.commands);
    auto goal = root.table("goal");
    if (goal) {
        scenario.goal = read_goal(*goal);
        scenario.goal->events = scene.commands;
    }
    const auto sun = read_view(root, scenario);
    root.finish();
    if (fault) return unusable(*fault);
    if (const auto wrong = sim::fault_of(params))
        return unusable(fmt::format("{}: {}", path.string(), *wrong));
    if (const auto wrong = fault_of_commands(params, scene.commands))
        return unusable(fmt::format("{}: {}", path.string(), *wrong));

    if (const auto given = ground->text("file")) scene.files.push_back(folder / *given);
    auto terrain =
        read_terrain(*ground, folder, {overrides.squares, file.weekly ? overrides.week : std::nullopt},
                     overrides.references, [&](const sim::Grid& grid) {
                         return overrides.memory.allows(
                             grid, scenario.lower.has_value(),
                             !things.empty() || woods_act || weather || has_things(scene.commands));
                     });
    if (fault) return unusable(*fault);
    if (!terrain) return unusable(terrain.error());
    add_files(terrain->files, scene);
    scene.warnings = std::move(terrain->warnings);
    if (trees.raster) scene.files.push_back(*trees.raster);
    const auto on_ground = trees_on(trees, *terrain, overrides.references, scene.files);
    if (!on_ground) return unusable(fmt::format("{}: {}", path.string(), on_ground.error()));
    scenario.trees = *on_ground;
    if (rule) terrain->cover = depth_by(*rule, *terrain);
    if (under_rule) {
        scenario.lower->depth = depth_by(*under_rule, *terrain);
        for (std::size_t i = 0; i < terrain->cover.size(); ++i) terrain->cover[i] += scenario.lower->depth[i];
        constexpr float kDeepestCover = sim::kDeepest / 2;
        if (const float most = *std::max_element(terrain->cover.begin(), terrain->cover.end());
            most > kDeepestCover)
            return unusable(
                fmt::format("{}: the cover and the material under it are {} m deep; at most {} m are allowed",
                            path.string(), most, kDeepestCover));
    }
    set_ground(scenario, *terrain);
    if (weather) place_weather(*weather, scenario);
    if (const auto beside = warning_of_pours(scenario.grid, scenario.has_data, scene.commands))
        scene.warnings.push_back(fmt::format("{}: {}", path.string(), *beside));
    stand(std::move(things), woods_act && !scenario.model, scenario);
    light_by(sun, root, scenario);
    if (fault) return unusable(*fault);
    if (goal)
        if (const auto wrong = fault_of_reach(scenario)) {
            TomlTable table = wrong->table.empty() ? *goal : goal->tables(wrong->table).at(wrong->index);
            table.blame(wrong->key, wrong->fact);
            return unusable(*fault);
        }
    return scene;
}

}  // namespace

Outcome<Scene> load_scene(std::string_view name_or_path, const Overrides& overrides) {
    const auto path = find_asset(AssetKind::kScene, name_or_path);
    if (!path) return tl::unexpected(path.error());
    const auto file = read_scene_file(*path);
    if (!file) return tl::unexpected(file.error());
    TomlFault fault;
    TomlTable root(file->document, "", path->string(), fault);
    auto scene = read_scene(root, *file, overrides, fault);
    // What does not go together may be a line of the easier one, which does not say what was read.
    if (!scene && file->harder_than && scene.error().sentence.find(path->string()) == std::string::npos)
        scene.error().sentence = fmt::format("{}: is harder than \"{}\": {}", path->string(),
                                             *file->harder_than, scene.error().sentence);
    return scene;
}

namespace {

// The parameters of a hill: those of its material, what the user chose, and sinks all around.
Outcome<sim::Params> params_of_hill(sim::Params params, const Overrides& overrides) {
    take_choices(overrides, params);
    if (const auto set = take_set(overrides, params); !set) return tl::unexpected(set.error());
    params.borders.fill(sim::Border::kSink);
    return params;
}

// Puts the release into the scenario as rolling layer at rest.
Outcome<void> add_release(const Terrain& terrain, const ReleaseFile& file, terrains::References references,
                          Scene& scene) {
    auto release = terrains::read_release(file.path, terrain, file.measured, references);
    if (!release) return unusable(release.error());
    if (const float most = *std::max_element(release->thickness.begin(), release->thickness.end());
        most > kDeepestRelease)
        return unusable(fmt::format("{}: {} m thick; at most {} m are allowed", file.path.string(), most,
                                    kDeepestRelease));
    add_files(release->files, scene);
    scene.files.push_back(file.path);
    scene.scenario.rolling = std::exchange(release->thickness, {});
    scene.release = std::move(*release);
    return {};
}

}  // namespace

Outcome<Scene> scene_of_terrain(const fs::path& dem, const std::optional<ReleaseFile>& release,
                                const Overrides& overrides) {
    constexpr int kUsualSquares = 256;
    const sim::Model model = overrides.model.value_or(sim::Model::kBcreInertial);
    if (const auto sound = check_choices(overrides, model); !sound) return tl::unexpected(sound.error());
    const auto material = load_material(overrides.material.value_or("snow-dry"), model);
    if (!material) return tl::unexpected(material.error());
    const int usual = overrides.own_grid ? terrains::GridChoice::kOwn : kUsualSquares;
    auto terrain =
        terrains::read_dem(dem,
                           {overrides.squares.value_or(usual),
                            [&](const sim::Grid& grid) { return overrides.memory.allows(grid, false); }},
                           overrides.references);
    if (!terrain) return unusable(terrain.error());
    if (overrides.crs)
        if (const auto set = terrains::set_system(*overrides.crs, *terrain); !set)
            return unusable(fmt::format("{}: {}", dem.string(), set.error()));

    Scene scene;
    scene.files = {dem, material->file};
    add_files(terrain->files, scene);
    scene.scenario.scene = scene.scenario.title = terrain->name;
    // The class of the avalanche is known when its release is.
    const auto chosen = [&](const sim::Params& params) { return params_of_hill(params, overrides); };
    const auto usual_params = chosen(material->params);
    if (!usual_params) return tl::unexpected(usual_params.error());
    take_material(scene.scenario, *material, *usual_params);
    set_ground(scene.scenario, *terrain);
    view_from_valley(scene.scenario);
    scene.warnings = std::move(terrain->warnings);
    std::optional<double> released;
    if (release) {
        if (auto added = add_release(*terrain, *release, overrides.references, scene); !added)
            return tl::unexpected(added.error());
        released = scene.release->volumes.on_ground;
    }
    const auto params = params_of(*material, overrides, released, scene).and_then(chosen);
    if (!params) return tl::unexpected(params.error());
    scene.scenario.params = *params;
    if (!release || !release->one_at_a_time) return scene;
    auto patches = terrains::read_release_patches(release->path, *terrain, release->measured);
    if (!patches) return unusable(patches.error());
    for (terrains::ReleasePatch& patch : *patches) {
        Scene own;  // only its class is of use, which is among its parameters
        const auto of_patch = params_of(*material, overrides, patch.volume, own).and_then(chosen);
        if (!of_patch) return tl::unexpected(of_patch.error());
        scene.patches.push_back({std::move(patch), *of_patch});
    }
    return scene;
}

namespace {

// Errors: a value outside `least` to `most`, at a vertex that counts.
Outcome<void> check_values(const sim::Grid& grid, std::span<const float> values,
                           std::span<const std::uint8_t> counts, const char* what, double least,
                           double most) {
    if (values.size() != grid.size())
        return unusable(fmt::format("{}: {} values for {} vertices", what, values.size(), grid.size()));
    for (std::size_t i = 0; i < values.size(); ++i) {
        const double value = values[i];
        if (counts[i] == 0 || (value >= least && value <= most)) continue;
        const std::size_t row = i / static_cast<std::size_t>(grid.nx),
                          column = i % static_cast<std::size_t>(grid.nx);
        return unusable(fmt::format("{}: {} m in row {}, column {}, outside {} to {} m", what, value, row,
                                    column, least, most));
    }
    return {};
}

// Errors: the heights of `terrain`, or the layers on them, are no ground for a world.
Outcome<void> check_ground(const Terrain& terrain, std::span<const float> rolling, const Memory& memory) {
    const sim::Grid& grid = terrain.grid;
    const int longer = std::max(grid.nx, grid.ny) - 1;
    if (std::min(grid.nx, grid.ny) < 3 || longer < terrains::kFewestSquares ||
        longer > terrains::kMostSquares)
        return unusable(
            fmt::format("heights of {} rows and {} columns: a grid has {} to {} squares along its longer "
                        "side and at least 2 along the other",
                        grid.ny, grid.nx, terrains::kFewestSquares, terrains::kMostSquares));
    if (!(grid.dx >= terrains::kSmallestCell && grid.dx <= terrains::kLargestCell))
        return unusable(fmt::format("a cell of {} m, outside {} to {} m", grid.dx, terrains::kSmallestCell,
                                    terrains::kLargestCell));
    if (std::ranges::find(terrain.has_data, 1) == terrain.has_data.end())
        return unusable("heights without any data");
    if (auto sound = check_values(grid, terrain.surface, terrain.has_data, "heights", terrains::kLowestGround,
                                  terrains::kHighestGround);
        !sound)
        return sound;
    const std::vector<std::uint8_t> all(grid.size(), 1);
    if (auto sound = check_values(grid, terrain.cover, all, "cover", 0, kDeepestRelease); !sound)
        return sound;
    if (auto sound = check_values(grid, rolling, all, "rolling", 0, kDeepestRelease); !sound) return sound;
    if (const auto allowed = memory.allows(grid, false); !allowed) return unusable(allowed.error());
    return {};
}

}  // namespace

Outcome<Scene> scene_of_heights(Terrain terrain, std::vector<float> rolling, const Overrides& overrides) {
    const sim::Model model = overrides.model.value_or(sim::Model::kBcreInertial);
    if (const auto sound = check_choices(overrides, model); !sound) return tl::unexpected(sound.error());
    if (const auto sound = check_ground(terrain, rolling, overrides.memory); !sound)
        return tl::unexpected(sound.error());
    const auto material = load_material(overrides.material.value_or("snow-dry"), model);
    if (!material) return tl::unexpected(material.error());
    terrains::fill_voids(terrain.grid, terrain.has_data, terrain.surface);

    Scene scene;
    scene.files = {material->file};
    scene.scenario.scene = scene.scenario.title = terrain.name;
    const double released = std::accumulate(rolling.begin(), rolling.end(), 0.0) * terrain.grid.cell_area();
    const auto params =
        params_of(*material, overrides, released > 0 ? std::optional(released) : std::nullopt, scene)
            .and_then([&](const sim::Params& of_class) { return params_of_hill(of_class, overrides); });
    if (!params) return tl::unexpected(params.error());
    take_material(scene.scenario, *material, *params);
    set_ground(scene.scenario, terrain);
    scene.scenario.rolling = std::move(rolling);
    view_from_valley(scene.scenario);
    return scene;
}

}  // namespace game
