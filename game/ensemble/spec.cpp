#include "game/ensemble/spec.h"

#include <algorithm>
#include <array>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "files/input.h"
#include "game/ensemble/sobol.h"
#include "game/files/toml_table.h"
#include "game/recording/format.h"
#include "game/scene/pressure.h"
#include "game/scene/scenario.h"
#include "xxhash.h"

namespace game {
namespace {

namespace fs = std::filesystem;

constexpr std::array kMapped{
    MappedInfo{Mapped::kThickness, "thickness", "m", 1000}, MappedInfo{Mapped::kSpeed, "speed", "m/s", 1000},
    MappedInfo{Mapped::kPressure, "pressure", "kPa", 1e5}, MappedInfo{Mapped::kArrival, "arrival", "s", 0}};

// Reads one [[variable]].
Variable read_variable(TomlTable& table, const Scene& scene) {
    Variable variable;
    const auto name = table.text("of").value_or("");
    double least = 0, most = 0;
    const sim::Params& params = scene.scenario.params;
    if (name == "release") {
        constexpr double kMostTimes = 10;
        variable.of = Variable::Of::kRelease, most = kMostTimes;
        if (std::ranges::none_of(scene.scenario.rolling, [](float thickness) { return thickness > 0; }))
            table.blame("of", "is release, and the world has none");
    } else if (name == "density") {
        variable.of = Variable::Of::kDensity, least = kLeastDensity, most = kGreatestDensity;
    } else if (const auto index = sim::param_from(name)) {
        variable.param = &sim::kParams[static_cast<std::size_t>(*index)];
        least = static_cast<double>(variable.param->least), most = static_cast<double>(variable.param->most);
        if (!sim::is_used_by(*variable.param, params.model))
            table.blame("of",
                        fmt::format("is not a parameter of the model {}", sim::to_string(params.model)));
    } else {
        table.blame("of", "is neither release, density nor a parameter that can be set");
    }
    int given = 0;
    std::vector<std::string_view> names;
    for (const DistributionInfo& info : distribution_infos()) {
        names.push_back(info.name);
        if (!table.has(info.name)) continue;
        ++given;
        const auto numbers = info.count == 0 ? table.numbers(info.name, 1, Distribution::kMostListed)
                                             : table.numbers(info.name, info.count);
        if (!numbers) {
            table.blame(info.name, fmt::format("is not a list of {}", info.numbers));
            continue;
        }
        variable.distribution = {info.kind, *numbers};
        if (const auto wrong = fault_of(variable.distribution, least, most)) table.blame(info.name, *wrong);
    }
    if (given != 1) table.blame("", fmt::format("needs exactly one of {}", fmt::join(names, ", ")));
    table.finish();
    return variable;
}

// Reads one [[map]]: each of its numbers is a map.
void read_map(TomlTable& table, const Scene& scene, Maps& maps) {
    const auto name = table.text("of").value_or("");
    const auto info = std::ranges::find(kMapped, name, &MappedInfo::name);
    if (info == kMapped.end()) return table.blame("of", "is not one of thickness, speed, pressure, arrival");
    if (info->of == Mapped::kPressure && !densities_of(scene.scenario))
        table.blame("of", "is pressure, and the density of the material is not known");
    if (info->of == Mapped::kArrival && table.has("over"))
        table.blame("over", "does not apply to arrival, which has percentiles alone");
    if (!table.has("over") && !table.has("percentiles"))
        table.blame(
            "", fmt::format("needs `over`, a list of numbers in {}, or `percentiles`, one in %", info->unit));
    if (table.has("over")) {
        const auto over = table.numbers("over", 1, Maps::kMostThresholds);
        for (const double least : over.value_or(std::vector<double>{})) {
            const Threshold threshold{info->of, least};
            if (!(least > 0 && least <= info->most))
                table.blame("over", fmt::format("has {}, which is not above 0 and at most {} {}", least,
                                                info->most, info->unit));
            if (std::ranges::find(maps.thresholds, threshold) != maps.thresholds.end())
                table.blame("over", fmt::format("has {} {} twice", least, info->unit));
            maps.thresholds.push_back(threshold);
        }
    }
    if (table.has("percentiles")) {
        const auto shares = table.numbers("percentiles", 1, Maps::kMostPercentiles);
        for (const double share : shares.value_or(std::vector<double>{})) {
            const Percentile percentile{info->of, share};
            if (!(share > 0 && share < 100))
                table.blame("percentiles", fmt::format("has {}, which is not above 0 and below 100", share));
            if (std::ranges::find(maps.percentiles, percentile) != maps.percentiles.end())
                table.blame("percentiles", fmt::format("has {} twice", share));
            maps.percentiles.push_back(percentile);
        }
    }
    table.finish();
}

// A file that the spec names, beside or below it, unless the user trusts it.
fs::path file_named(TomlTable& root, std::string_view key, const fs::path& folder,
                    terrains::References references) {
    fs::path file = folder / root.text(key).value_or("");
    if (references != terrains::References::kAllowed && !files::is_within(folder, file))
        root.blame(key, "lies outside the folder of this file; add --allow-references if you trust it");
    return file;
}

Outcome<Scene> read_world(TomlTable& root, const fs::path& folder, Overrides overrides, TomlFault& fault) {
    if (const auto squares = root.whole("grid", 8, 4096)) overrides.squares = static_cast<int>(*squares);
    if (const auto material = root.text("material")) {
        overrides.material = *material;
        if (material->find('/') != std::string::npos || material->find('.') != std::string::npos)
            overrides.material = file_named(root, "material", folder, overrides.references).string();
    }
    if (const auto model = root.text("model")) {
        overrides.model = sim::model_from(*model);
        if (!overrides.model) root.blame("model", "is not one of bcre, bcre-inertial, voellmy");
    }
    if (const auto crs = root.text("crs")) overrides.crs = *crs;
    if (root.has("scene") == root.has("terrain")) root.blame("", "needs either `scene` or `terrain`");
    std::optional<terrains::Thickness> measured;
    if (const auto thickness = root.text("thickness")) {
        if (*thickness != "vertical" && *thickness != "normal")
            root.blame("thickness", "is neither vertical nor normal");
        measured = *thickness == "normal" ? terrains::Thickness::kNormal : terrains::Thickness::kVertical;
    }
    if (root.has("scene")) {
        for (const char* key : {"release", "thickness", "crs", "polygons"})
            if (root.has(key)) root.blame(key, "applies to a `terrain` alone");
        const std::string scene = root.text("scene").value_or("");
        const bool is_file = scene.find('.') != std::string::npos || scene.find('/') != std::string::npos;
        const std::string named =
            is_file ? file_named(root, "scene", folder, overrides.references).string() : scene;
        if (fault) return unusable(*fault);
        auto loaded = load_scene(named, overrides);
        if (!loaded && !is_file && loaded.error().status == Failure::kUnusable) {
            root.blame("scene", "cannot be used: " + loaded.error().sentence);
            return unusable(*fault);
        }
        return loaded;
    }
    const fs::path dem = file_named(root, "terrain", folder, overrides.references);
    const fs::path release = file_named(root, "release", folder, overrides.references);
    if (!root.has("release")) root.blame("", "needs a `release` beside its terrain");
    bool one_at_a_time = false;
    if (const auto polygons = root.text("polygons")) {
        one_at_a_time = *polygons == "one at a time";
        if (!one_at_a_time && *polygons != "together")
            root.blame("polygons", "is neither \"together\" nor \"one at a time\"");
    }
    return fault ? unusable(*fault)
                 : scene_of_terrain(dem, ReleaseFile{release, measured, one_at_a_time}, overrides);
}

std::string identity_of(const EnsembleSpec& spec) {
    Header header;
    header.scenario = spec.scene.scenario;
    Json of = to_json(header);
    for (const char* key : {"program", "look", "camera", "light", "wind"}) of.erase(key);
    std::string text = of.dump(-1, ' ', false, Json::error_handler_t::replace);
    for (const TimedCommand& each : spec.scene.commands) write(each, text);
    text += fmt::format("{} {}", spec.seed, spec.seconds);
    for (const Variable& each : spec.variables)
        text += fmt::format("; {} {} {}", each.name(), static_cast<int>(each.distribution.kind),
                            fmt::join(each.distribution.numbers, " "));
    if (!spec.scene.patches.empty()) text += "; one at a time";
    for (const auto& [release, params] : spec.scene.patches)
        text += fmt::format("; {} {} {}", release.vertices.size(),
                            release.vertices.empty() ? 0 : release.vertices.front(), release.volume);
    for (const Threshold& each : spec.maps.thresholds)
        text += fmt::format("; {} {}", info_of(each.of).name, each.least);
    for (const Mapped each : spec.maps.spread()) text += fmt::format("; spread of {}", info_of(each).name);
    return hex(XXH3_64bits(text.data(), text.size()));
}

}  // namespace

std::string_view Variable::name() const {
    return of == Of::kRelease ? "release" : of == Of::kDensity ? "density" : param->name;
}
std::string_view Variable::unit() const {
    return of == Of::kRelease ? "1" : of == Of::kDensity ? "kg/m3" : param->unit;
}

const MappedInfo& info_of(Mapped mapped) {
    return *std::ranges::find(kMapped, mapped, &MappedInfo::of);
}

std::vector<Mapped> Maps::spread() const {
    std::vector<Mapped> quantities;
    for (const MappedInfo& info : kMapped)
        if (std::ranges::find(percentiles, info.of, &Percentile::of) != percentiles.end())
            quantities.push_back(info.of);
    return quantities;
}

std::vector<double> EnsembleSpec::sample(std::int64_t member) const {
    std::vector<double> values;
    for (const Variable& variable : variables)
        values.push_back(value_at(variable.distribution,
                                  sobol(static_cast<std::uint64_t>(seed), static_cast<int>(values.size()),
                                        static_cast<std::uint32_t>(member - 1))));
    return values;
}

std::optional<std::size_t> EnsembleSpec::patch_of(std::int64_t member) const {
    if (scene.patches.empty()) return std::nullopt;
    return static_cast<std::size_t>(member - 1) % scene.patches.size() + 1;
}

Outcome<Scenario> EnsembleSpec::scenario_of(std::int64_t member) const {
    Scenario scenario = scene.scenario;
    scenario.title = fmt::format("{}, member {}", title, member);
    if (const auto number = patch_of(member)) {
        const auto& [release, params] = scene.patches[*number - 1];
        if (release.vertices.empty())
            return unusable(fmt::format("polygon {} of its release covers no ground", *number));
        scenario.params = params;
        std::ranges::fill(scenario.rolling, 0.f);
        for (std::size_t i = 0; i < release.vertices.size(); ++i)
            scenario.rolling[release.vertices[i]] = release.thickness[i];
    }
    const std::vector<double> sample = this->sample(member);
    for (std::size_t i = 0; i < variables.size(); ++i) switch (variables[i].of) {
            case Variable::Of::kParameter:
                scenario.params.*variables[i].param->value = static_cast<float>(sample[i]);
                break;
            case Variable::Of::kDensity:
                scenario.density = sample[i];
                break;
            case Variable::Of::kRelease:
                for (float& thickness : scenario.rolling) thickness *= static_cast<float>(sample[i]);
                break;
        }
    if (!scenario.rolling.empty() && *std::ranges::max_element(scenario.rolling) > kDeepestRelease)
        return unusable(fmt::format("a release of over {} m", kDeepestRelease));
    if (const auto wrong = sim::fault_of(scenario.params)) return unusable(*wrong);
    if (const auto wrong = fault_of_commands(scenario.params, scene.commands)) return unusable(*wrong);
    return scenario;
}

Outcome<EnsembleSpec> read_ensemble_spec(const fs::path& file, const Overrides& overrides) {
    const auto document = parse_toml(file);
    if (!document) return tl::unexpected(document.error());
    TomlFault fault;
    TomlTable root(*document, "", file.string(), fault);
    EnsembleSpec spec;
    spec.file = file;
    spec.title = root.text("title").value_or(file.stem().string());
    spec.members = root.whole("members", 1, EnsembleSpec::kMostMembers).value_or(0);
    constexpr std::int64_t kGreatestSeed = 1'000'000'000;
    spec.seed = root.whole("seed", 0, kGreatestSeed).value_or(spec.seed);
    spec.seconds = root.number("seconds", 1, 86'400).value_or(spec.seconds);
    auto scene =
        read_world(root, file.parent_path().empty() ? fs::path(".") : file.parent_path(), overrides, fault);
    if (fault) return unusable(*fault);
    if (!scene) return tl::unexpected(scene.error());
    spec.scene = std::move(*scene);
    if (!spec.scene.patches.empty() && !root.has("members"))
        spec.members = static_cast<std::int64_t>(spec.scene.patches.size());  // each once
    if (spec.members == 0) root.blame("", "needs `members`: how many runs");
    if (spec.members > EnsembleSpec::kMostMembers)
        root.blame("release", fmt::format("has {} polygons; at most {} can be released one at a time",
                                          spec.members, EnsembleSpec::kMostMembers));
    spec.scene.scenario.goal.reset();
    if (spec.scene.scenario.flow) root.blame("scene", "is a flow demo, which has no avalanche");
    for (TomlTable& table : root.tables("variable")) {
        Variable variable = read_variable(table, spec.scene);
        const auto is_same = [&](const Variable& each) { return each.name() == variable.name(); };
        if (!fault && std::ranges::any_of(spec.variables, is_same))
            table.blame("of", fmt::format("is {} a second time", variable.name()));
        if (fault) return unusable(*fault);
        spec.variables.push_back(std::move(variable));
    }
    for (TomlTable& table : root.tables("map")) {
        read_map(table, spec.scene, spec.maps);
        if (fault) return unusable(*fault);
    }
    root.finish();
    if (spec.variables.empty() && spec.scene.patches.empty())
        root.blame("", "needs at least one [[variable]], or polygons released one at a time");
    if (spec.variables.size() > static_cast<std::size_t>(kMostSobolDimensions))
        root.blame("", fmt::format("has {} variables; at most {} are allowed", spec.variables.size(),
                                   kMostSobolDimensions));
    if (spec.maps.thresholds.size() > Maps::kMostThresholds)
        root.blame("", fmt::format("maps {} thresholds; at most {} are allowed", spec.maps.thresholds.size(),
                                   Maps::kMostThresholds));
    if (spec.maps.percentiles.size() > Maps::kMostPercentiles)
        root.blame("", fmt::format("maps {} percentiles; at most {} are allowed",
                                   spec.maps.percentiles.size(), Maps::kMostPercentiles));
    if (fault) return unusable(*fault);
    if (spec.maps.thresholds.empty() && spec.maps.percentiles.empty())
        spec.maps.thresholds = {{Mapped::kThickness, 0.1}};
    if (!spec.scene.patches.empty())
        spec.maps.hardest = densities_of(spec.scene.scenario) ? Mapped::kPressure : Mapped::kSpeed;
    spec.identity = identity_of(spec);
    return spec;
}

}  // namespace game
