#include "game/scene/scene_trees.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "files/input.h"
#include "game/base/limits.h"
#include "game/scene/shown_numbers.h"
#include "terrains/share_raster.h"

namespace game {
namespace {

namespace fs = std::filesystem;

// Twice the area of a triangle, above 0 if a, b, c turn left.
double turn(glm::dvec2 a, glm::dvec2 b, glm::dvec2 c) {
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

bool cross(glm::dvec2 a, glm::dvec2 b, glm::dvec2 c, glm::dvec2 d) {
    return turn(a, b, c) * turn(a, b, d) < 0 && turn(c, d, a) * turn(c, d, b) < 0;
}

}  // namespace

TreesTable read_trees(TomlTable& table, const fs::path& folder, terrains::References references) {
    TreesTable trees;
    render::TreeRules& rules = trees.rules;
    if (!table.has("density")) table.blame("", "needs a density, in trees per hectare");
    table.numbers(kTreeNumbers, rules);
    rules.seed = static_cast<std::uint32_t>(table.whole("seed", 0, 1'000'000).value_or(rules.seed));
    if (const auto corners = table.places("polygon", kFewestTreeCorners, kMostTreeCorners)) {
        rules.polygon = *corners;
        if (const auto sides = crossing_sides(rules.polygon))
            table.blame("polygon", fmt::format("crosses itself: side {}, from corner {}, meets side {}",
                                               sides->first, sides->first, sides->second));
    }
    if (const auto raster = table.text("raster")) {
        trees.raster = folder / *raster;
        if (references != terrains::References::kAllowed && !files::is_within(folder, *trees.raster))
            table.blame("raster",
                        "lies outside the scene's folder; add --allow-references if you trust the scene");
    }
    table.finish();
    return trees;
}

std::optional<std::pair<std::size_t, std::size_t>> crossing_sides(const std::vector<glm::dvec2>& polygon) {
    const std::size_t count = polygon.size();
    for (std::size_t i = 0; i < count; ++i)
        for (std::size_t j = i + 1; j < count; ++j)
            if (cross(polygon[i], polygon[(i + 1) % count], polygon[j], polygon[(j + 1) % count]))
                return std::pair(i + 1, j + 1);
    return std::nullopt;
}

tl::expected<render::TreeRules, std::string> trees_on(const TreesTable& trees,
                                                      const terrains::Terrain& terrain,
                                                      terrains::References references,
                                                      std::vector<fs::path>& files) {
    render::TreeRules rules = trees.rules;
    const double width = (terrain.grid.nx - 1) * static_cast<double>(terrain.grid.dx),
                 height = (terrain.grid.ny - 1) * static_cast<double>(terrain.grid.dx);
    for (std::size_t i = 0; i < rules.polygon.size(); ++i) {
        const glm::dvec2 corner = rules.polygon[i];
        if (corner.x < 0 || corner.x > width || corner.y < 0 || corner.y > height)
            return tl::unexpected(
                fmt::format("corner {} of the trees' polygon, {:.6g}, {:.6g}, is beside the grid, which is "
                            "{:.6g} × {:.6g} m",
                            i + 1, corner.x, corner.y, width, height));
    }
    if (trees.raster) {
        auto shares =
            terrains::read_shares(*trees.raster, terrain.grid, terrain.georeference, references, files);
        if (!shares) return tl::unexpected(shares.error());
        rules.shares = std::move(*shares);
    }
    return rules;
}

}  // namespace game
