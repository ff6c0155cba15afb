#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <tl/expected.hpp>

#include "game/files/toml_table.h"
#include "render/woods/woods.h"
#include "terrains/references.h"
#include "terrains/terrain.h"

namespace game {

// The [trees] of a scene file.

// What [trees] says before the ground is known.
struct TreesTable {
    render::TreeRules rules;
    std::optional<std::filesystem::path> raster;  // of shares
};

// Reads [trees]. A raster's path is relative to `folder`, the scene's, and may leave it only if references
// are allowed.
TreesTable read_trees(TomlTable& table, const std::filesystem::path& folder, terrains::References references);

// The first two sides of a polygon that cross, counted from 1; side i runs from corner i to the next one.
std::optional<std::pair<std::size_t, std::size_t>> crossing_sides(const std::vector<glm::dvec2>& polygon);

// The rules on a ground: checks that the corners are on its grid, and reads the raster, which must have the
// size and place of the grid. No data is 0. `files` gets every file that was read. Errors, in one sentence
// without the scene: a corner beside the grid, a raster that cannot be read, of another size or place, or
// with a value outside 0 to 1.
tl::expected<render::TreeRules, std::string> trees_on(const TreesTable& trees,
                                                      const terrains::Terrain& terrain,
                                                      terrains::References references,
                                                      std::vector<std::filesystem::path>& files);

}  // namespace game
