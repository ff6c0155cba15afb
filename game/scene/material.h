#pragma once

#include <filesystem>
#include <string>

#include "game/base/outcome.h"
#include "game/files/toml_table.h"
#include "render/look.h"
#include "sim/world/params.h"

namespace game {

// What rolls and lies: how it looks, and its numbers for one model.
struct Material {
    std::filesystem::path file;
    std::string name;   // of its file
    std::string title;  // "loose dry snow"
    render::Look look;
    sim::Params params;  // of the model asked for
};

// Reads assets/materials/NAME.toml or a file. Errors: unknown name, damage, or no block for this model.
Outcome<Material> load_material(std::string_view name_or_path, sim::Model model);

// Sets every physics number that `table` names, by its name in sim/world/params.h; `…_slope` may be given in
// degrees as `…_angle`. `model` says which numbers there are.
void read_physics_numbers(TomlTable& table, sim::Model model, sim::Params& params);

}  // namespace game
