#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "game/base/outcome.h"
#include "game/files/toml_table.h"
#include "render/view/look.h"
#include "sim/world/params.h"

namespace game {

// Avalanches that release less than a volume, and a material's parameters in them.
struct SizeClass {
    std::string name;
    std::optional<double> below;  // m³; nothing in the last one
    sim::Params params;           // of the requested model: those of the material, but for its friction
};

// A material: its appearance, and its parameters for one model.
struct Material {
    std::filesystem::path file;
    std::string name;               // of its file, without extension
    std::string title;              // "loose dry snow"
    std::optional<double> density;  // kg/m³, while it flows; 1 to 3000
    render::Look look;
    sim::Params params;  // of the requested model
    std::vector<SizeClass>
        sizes;  // by rising volume, without gaps; empty: one friction for all, or none in bcre
};
// The class of avalanches that release so much; null if the material has no classes.
const SizeClass* size_of(const Material& material, double released_m3);

// Reads assets/materials/NAME.toml or a file. Errors:
// unknown name, a damaged file, or no block for this model.
Outcome<Material> load_material(std::string_view name_or_path, sim::Model model);

// Adds the look of a lower material to that of the upper one: it lies on the ground.
void take_look_of_lower(const render::Look& lower, render::Look& look);

// Sets every physics parameter that `table` names, spelled as in sim/world/params.h; `…_slope` may be given
// in degrees as `…_angle`. `model` determines which parameters exist.
void read_physics_numbers(TomlTable& table, sim::Model model, sim::Params& params);

}  // namespace game
