#include "game/scene/material.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "game/files/assets.h"
#include "game/scene/scenario.h"
#include "game/scene/shown_numbers.h"

namespace game {
namespace {

// Converts sRGB, 0 to 255, to linear light.
float linear(double srgb) {
    const double c = srgb / 255;
    return static_cast<float>(c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4));
}

void read_colour(TomlTable& table, std::string_view key, glm::vec3& colour) {
    const auto rgb = table.numbers(key, 3);
    if (!rgb) return;
    for (const double channel : *rgb)
        if (channel < 0 || channel > 255) return table.blame(key, "has a number outside 0 to 255");
    colour = {linear((*rgb)[0]), linear((*rgb)[1]), linear((*rgb)[2])};
}

void read_look(TomlTable& table, render::Look& look) {
    read_colour(table, "rock", look.rock);
    read_colour(table, "meadow", look.meadow);
    read_colour(table, "standing", look.standing);
    read_colour(table, "rolling", look.rolling);
    if (glm::vec3 turf{-1}; read_colour(table, "turf", turf), turf.x >= 0) look.turf = turf;
    table.numbers(kLookNumbers, look);
    if (const auto name = table.text("texture")) {
        if (const auto pattern = render::flow_pattern_named(*name))
            look.flow = render::FlowLook{*pattern};
        else
            table.blame("texture", fmt::format("is not a known texture; known are {}",
                                               fmt::join(render::kFlowPatterns, ", ")));
    }
    table.numbers(kPowderNumbers, look.powder);
    look.powder.colour = look.standing;
    read_colour(table, "powder_colour", look.powder.colour);
    table.finish();
}

// "start_slope" may also be given as the angle "start_angle"; empty if the parameter is not a slope.
std::string angle_key(const sim::ParamInfo& info) {
    std::string key(info.name);
    const auto at = key.find("_slope");
    if (info.unit != "1" || at == std::string::npos) return {};
    return key.replace(at, 6, "_angle");
}

void read_number(TomlTable& table, const sim::ParamInfo& info, sim::Params& params) {
    const auto value = table.number(info.name, info.least, info.most);
    if (!value) return;
    params.*info.value = static_cast<float>(*value);
    if (info.value == &sim::Params::drag_exponent && std::remainder(*value, 0.125) != 0)
        table.blame(info.name, "is no multiple of 0.125");
}

// `cohesion`, N₀ in Pa, becomes the thickness that weighs as much.
void read_cohesion(TomlTable& table, const std::optional<double>& density, sim::Params& params) {
    constexpr double kGreatest = 20000;  // Pa
    const auto cohesion = table.number("cohesion", 0, kGreatest);
    if (!cohesion) return;
    if (!density) return table.blame("cohesion", "needs the density of the material");
    params.cohesion_depth = static_cast<float>(*cohesion / (*density * sim::kGravity));
}

// `[[size]]`: names, bounds in m³ and the friction that differs. `material`: with its own parameters.
void read_sizes(TomlTable& root, sim::Model model, Material& material) {
    constexpr std::array kOfSize{&sim::Params::friction, &sim::Params::drag, &sim::Params::drag_exponent,
                                 &sim::Params::fluidization, &sim::Params::cohesion_depth};
    constexpr double kMost = 1e10;  // m³
    std::vector<TomlTable> tables = root.tables("size");
    for (TomlTable& table : tables) {
        SizeClass size{table.text("name").value_or(""), table.number("below", 1, kMost), material.params};
        sim::Params unused;
        sim::Params& params = sim::has_momentum(model) ? size.params : unused;
        for (const sim::ParamInfo& info : sim::kParams)
            if (std::ranges::find(kOfSize, info.value) != kOfSize.end()) read_number(table, info, params);
        read_cohesion(table, material.density, params);
        table.finish();
        const auto has_its_name = [&](const SizeClass& other) { return other.name == size.name; };
        if (size.name.empty() || std::ranges::any_of(material.sizes, has_its_name))
            return table.blame("name", "is missing, empty or that of another class");
        if (const SizeClass* before = material.sizes.empty() ? nullptr : &material.sizes.back()) {
            if (!before->below)
                return table.blame("", fmt::format("overlaps with '{}', which has no 'below'", before->name));
            if (size.below && *size.below <= *before->below)
                return table.blame(
                    "below", fmt::format("is {:g}, so the class overlaps with '{}', below {:g}", *size.below,
                                         before->name, *before->below));
        }
        material.sizes.push_back(std::move(size));
    }
    if (!material.sizes.empty() && material.sizes.back().below)
        tables.back().blame(
            "below", fmt::format("leaves a gap: from {:g} m3 on there is no class; the last has no 'below'",
                                 *material.sizes.back().below));
}

}  // namespace

const SizeClass* size_of(const Material& material, double released_m3) {
    const auto found = std::ranges::find_if(
        material.sizes, [&](const SizeClass& size) { return !size.below || released_m3 < *size.below; });
    return found == material.sizes.end() ? nullptr : &*found;
}

void read_physics_numbers(TomlTable& table, sim::Model model, sim::Params& params) {
    for (const sim::ParamInfo& info : sim::kParams) {
        if (!sim::is_used_by(info, model)) continue;
        read_number(table, info, params);
        const std::string angle = angle_key(info);
        if (angle.empty()) continue;
        if (const auto degrees = table.number(angle, 0, 84))
            params.*info.value = static_cast<float>(std::tan(*degrees * 3.14159265358979323846 / 180));
    }
}

void take_look_of_lower(const render::Look& lower, render::Look& look) {
    look.lower_standing = lower.standing;
    look.lower_rolling = lower.rolling;
    look.lower_turf = lower.turf;
    look.lower_powder = lower.powder;
    look.rock = lower.rock;
    look.meadow = lower.meadow;
}

Outcome<Material> load_material(std::string_view name_or_path, sim::Model model) {
    const auto path = find_asset(AssetKind::kMaterial, name_or_path);
    if (!path) return tl::unexpected(path.error());
    const auto document = parse_toml(*path);
    if (!document) return tl::unexpected(document.error());

    Material material;
    material.file = *path;
    material.name = path->stem().string();
    material.params.model = model;
    TomlFault fault;
    TomlTable root(*document, "", path->string(), fault);
    material.title = root.text("title").value_or(material.name);
    material.density = root.number("density", kLeastDensity, kGreatestDensity);
    if (auto look = root.table("look")) read_look(*look, material.look);

    bool has_block = false;
    for (const sim::Model each : sim::kEveryModel) {
        auto block = root.table(sim::to_string(each));
        if (!block) continue;
        sim::Params unused;
        sim::Params& params = each == model ? material.params : unused;
        read_physics_numbers(*block, each, params);
        if (sim::has_momentum(each)) read_cohesion(*block, material.density, params);
        block->finish();
        has_block |= each == model;
    }
    read_sizes(root, model, material);
    if (!sim::has_momentum(model)) material.sizes.clear();  // it has no friction
    root.finish();
    if (fault) return unusable(*fault);
    if (!has_block)
        return unusable(fmt::format("{}: has no [{}] block, so it does not support that model",
                                    path->string(), sim::to_string(model)));
    if (const auto wrong = sim::fault_of(material.params))
        return unusable(fmt::format("{}: {}", path->string(), *wrong));
    for (const SizeClass& size : material.sizes)
        if (const auto wrong = sim::fault_of(size.params))
            return unusable(fmt::format("{}: size '{}': {}", path->string(), size.name, *wrong));
    return material;
}

}  // namespace game
