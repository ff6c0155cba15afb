#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <tl/expected.hpp>

#include "game/files/toml_table.h"
#include "game/scene/scenario.h"
#include "terrains/references.h"
#include "terrains/resample.h"
#include "terrains/terrain.h"

namespace game {

// The ground of a scene file: its [terrain], and the depth of its [cover].

// What is wished in place of what the table says.
struct TerrainWish {
    std::optional<int> squares;        // along the longer side
    std::optional<std::int64_t> seed;  // of a generator that has one
};

// Reads [terrain]. A file's path is relative to `folder`, the scene's, and may leave
// it only if references are allowed. `allowed` may refuse the grid. Errors: an empty sentence if
// the table has already reported the fault, else the fault of the terrain's file.
tl::expected<terrains::Terrain, std::string> read_terrain(TomlTable& table,
                                                          const std::filesystem::path& folder,
                                                          const TerrainWish& wished,
                                                          terrains::References references,
                                                          terrains::GridChoice::Allowed allowed);

// The depth of the cover on a ground that has none of its own: `depth` where the ground is above `above` +
// `fade` and gentler than `bare` − 10°, none below `above` or where steeper than `bare`.
struct CoverRule {
    double depth = 0;     // m
    double above = -1e6;  // m
    double fade = 1;      // m
    double bare = 90;     // deg
};

// Nothing if [cover] gives no depth: then the terrain's depth applies.
std::optional<CoverRule> read_cover_rule(TomlTable& table);
// Depth of the cover, m, at each vertex.
std::vector<float> depth_by(const CoverRule& rule, const terrains::Terrain& terrain);

inline constexpr double kBareSlope = 50;  // deg; cover_ground() leaves steeper rock bare
// Covers the ground of a scenario without any material with so much of its own, m. The surface stays where it is.
void cover_ground(Scenario& scenario, double depth);

}  // namespace game
