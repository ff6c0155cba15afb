#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <tl/expected.hpp>

#include "game/files/toml_table.h"
#include "terrains/references.h"
#include "terrains/resample.h"
#include "terrains/terrain.h"

namespace game {

// The ground of a scene file: its [terrain], and how deep [cover] lies on it.

// Reads [terrain]; a file's path is relative to `folder`, the scene's, and leads out of it only if references
// are allowed. `wished`: squares along the longer side, instead of those the file says; `allowed` may refuse
// the grid. Errors: the table is to blame and says so itself, the sentence is empty then; or what is wrong
// with the terrain's file.
tl::expected<terrains::Terrain, std::string> read_terrain(TomlTable& table,
                                                          const std::filesystem::path& folder,
                                                          std::optional<int> wished,
                                                          terrains::References references,
                                                          terrains::GridChoice::Allowed allowed);

// How deep the cover lies on a ground that has none of its own: `depth` where the
// ground is above `above` + `fade` and gentler than `bare` − 10°, none below `above` or where steeper than
// `bare`.
struct CoverRule {
    double depth = 0;     // m
    double above = -1e6;  // m
    double fade = 1;      // m
    double bare = 90;     // deg
};

// Nothing where [cover] gives no depth: then it is as deep as the terrain says.
std::optional<CoverRule> read_cover_rule(TomlTable& table);
// How deep it lies, m, at each vertex.
std::vector<float> depth_by(const CoverRule& rule, const terrains::Terrain& terrain);

}  // namespace game
