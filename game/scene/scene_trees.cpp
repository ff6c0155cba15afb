#include "game/scene/scene_trees.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "files/input.h"
#include "game/base/limits.h"
#include "game/scene/shown_numbers.h"
#include "terrains/dem_gdal.h"

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

bool is_same_place(const terrains::Georeference& a, const terrains::Georeference& b, double apart) {
    if (!a.has_coordinates() || !b.has_coordinates()) return true;  // a generated terrain is nowhere
    return (a.wkt().empty() || b.wkt().empty() || a.wkt() == b.wkt()) &&
           std::abs(a.origin_x() - b.origin_x()) <= apart && std::abs(a.origin_y() - b.origin_y()) <= apart;
}

std::string size_of(const sim::Grid& grid) {
    return fmt::format("{} × {} vertices of {:.6g} m", grid.nx, grid.ny, grid.dx);
}

// One value for each vertex, 0 to 255 for 0 to 1.
tl::expected<std::vector<std::uint8_t>, std::string> read_shares(const fs::path& file,
                                                                 const terrains::Terrain& terrain,
                                                                 terrains::References references,
                                                                 std::vector<fs::path>& files) {
    const sim::Grid& grid = terrain.grid;
    const auto raster = terrains::read_dem(file, terrains::GridChoice(std::max(grid.nx, grid.ny) - 1),
                                           references, terrains::Quantity::kShare);
    if (!raster) return tl::unexpected(raster.error());
    files.insert(files.end(), raster->files.begin(), raster->files.end());
    const sim::Grid& own = raster->grid;
    const double cell = grid.dx;
    if (own.nx != grid.nx || own.ny != grid.ny || std::abs(static_cast<double>(own.dx) - cell) > 0.01 * cell)
        return tl::unexpected(fmt::format("{}: spans {}, and the grid has {}; they must be the same",
                                          file.string(), size_of(own), size_of(grid)));
    if (!is_same_place(raster->georeference, terrain.georeference, 0.5 * cell))
        return tl::unexpected(fmt::format(
            "{}: begins at {:.1f}, {:.1f}, and the grid at {:.1f}, {:.1f}; they must be at the same place",
            file.string(), raster->georeference.origin_x(), raster->georeference.origin_y(),
            terrain.georeference.origin_x(), terrain.georeference.origin_y()));
    std::vector<std::uint8_t> shares(grid.size());
    for (std::size_t i = 0; i < shares.size(); ++i) {
        if (raster->has_data[i] == 0) continue;
        // The reader bounds them, but between pixels a plane is fitted, which may lie a little beyond.
        const double share = raster->surface[i];
        shares[i] = static_cast<std::uint8_t>(std::lround(255 * std::clamp(share, 0.0, 1.0)));
    }
    return shares;
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
        auto shares = read_shares(*trees.raster, terrain, references, files);
        if (!shares) return tl::unexpected(shares.error());
        rules.shares = std::move(*shares);
    }
    return rules;
}

}  // namespace game
