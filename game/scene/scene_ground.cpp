#include "game/scene/scene_ground.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

#include "files/input.h"
#include "terrains/dem_gdal.h"
#include "terrains/generators.h"
#include "terrains/heightmap_image.h"
#include "terrains/limits.h"

namespace game {
namespace {

namespace fs = std::filesystem;
using terrains::GridChoice;
using terrains::Terrain;
using MaybeTerrain = tl::expected<Terrain, std::string>;

MaybeTerrain generate(TomlTable& table, const std::string& name, const GridChoice& choice,
                      std::optional<std::int64_t> wished_seed) {
    const terrains::Generator* generator = terrains::find_generator(name);
    if (!generator) {
        table.blame("generator", "is none of " + terrains::generator_names());
        return tl::unexpected(std::string());
    }
    std::vector<double> values;
    for (const auto& number : generator->numbers)
        values.push_back(table.number(number.name, number.lowest, number.highest).value_or(number.usual));
    std::int64_t seed = 1;
    if (generator->seeded)
        seed = table.whole("seed", 0, std::numeric_limits<std::int64_t>::max()).value_or(seed);
    table.finish();
    if (generator->seeded) seed = wished_seed.value_or(seed);
    auto made = generator->make(values, static_cast<std::uint64_t>(seed), choice);
    if (!made) return tl::unexpected(made.error());
    return std::move(made->terrain);
}

MaybeTerrain read_file(TomlTable& table, const fs::path& file, const GridChoice& choice,
                       terrains::References references) {
    const auto pixel = table.number("pixel", terrains::kSmallestCell, terrains::kLargestCell);
    const auto lowest = table.number("lowest", -12000, 9000), highest = table.number("highest", -12000, 9000);
    table.finish();
    if (!pixel) return terrains::read_dem(file, choice, references);
    if (!lowest || !highest) {
        table.blame("pixel", "makes the file an image, which also needs lowest and highest");
        return tl::unexpected(std::string());
    }
    return terrains::read_heightmap(file, {*pixel, *lowest, *highest}, choice);
}

}  // namespace

MaybeTerrain read_terrain(TomlTable& table, const fs::path& folder, const TerrainWish& wished,
                          terrains::References references, GridChoice::Allowed allowed) {
    const auto grid = table.whole("grid", terrains::kFewestSquares, terrains::kMostSquares);
    const auto generator = table.text("generator"), file = table.text("file");
    if (!grid) table.blame("grid", "is missing: the number of squares along the longer side");
    if (generator.has_value() == file.has_value()) table.blame("", "needs either a generator or a file");
    if (!grid || generator.has_value() == file.has_value()) return tl::unexpected(std::string());
    const GridChoice choice(wished.squares.value_or(static_cast<int>(*grid)), std::move(allowed));
    if (generator) return generate(table, *generator, choice, wished.seed);
    if (references != terrains::References::kAllowed && !files::is_within(folder, folder / *file)) {
        table.blame("file", "lies outside the scene's folder; add --allow-references if you trust the scene");
        return tl::unexpected(std::string());
    }
    return read_file(table, folder / *file, choice, references);
}

std::optional<CoverRule> read_cover_rule(TomlTable& table) {
    const auto depth = table.number("depth", 0, 50);
    CoverRule rule;
    rule.above = table.number("above", -12000, 9000).value_or(rule.above);
    rule.fade = table.number("fade", 0.1, 5000).value_or(rule.fade);
    rule.bare = table.number("bare", 11, 90).value_or(rule.bare);
    if (!depth) return std::nullopt;
    rule.depth = *depth;
    return rule;
}

std::vector<float> depth_by(const CoverRule& rule, const Terrain& terrain) {
    std::vector<float> depths(terrain.grid.size());
    const int nx = terrain.grid.nx, ny = terrain.grid.ny;
    const auto surface = [&](int x, int y) {
        const auto i = static_cast<std::size_t>(std::clamp(y, 0, ny - 1)) * static_cast<std::size_t>(nx) +
                       static_cast<std::size_t>(std::clamp(x, 0, nx - 1));
        return static_cast<double>(terrain.surface[i]);
    };
    for (int y = 0; y < ny; ++y)
        for (int x = 0; x < nx; ++x) {
            const double run = 2.0 * terrain.grid.dx;
            const double gx = (surface(x + 1, y) - surface(x - 1, y)) / run;
            const double gy = (surface(x, y + 1) - surface(x, y - 1)) / run;
            const double slope_deg = std::atan(std::hypot(gx, gy)) * 180 / 3.14159265358979323846;
            const double high = std::clamp((surface(x, y) - rule.above) / rule.fade, 0.0, 1.0);
            const double gentle = std::clamp((rule.bare - slope_deg) / 10, 0.0, 1.0);
            // Round to millimetres, so that the last bits of another maths library have no effect.
            const double depth = std::rint(rule.depth * high * gentle * 1024) / 1024;
            depths[static_cast<std::size_t>(y) * static_cast<std::size_t>(nx) + static_cast<std::size_t>(x)] =
                static_cast<float>(depth);
        }
    return depths;
}

void cover_ground(Scenario& scenario, double depth) {
    Terrain terrain;
    terrain.grid = scenario.grid;
    terrain.surface = scenario.bedrock;
    scenario.depth = depth_by({.depth = depth, .bare = kBareSlope}, terrain);
    for (std::size_t i = 0; i < scenario.bedrock.size(); ++i) scenario.bedrock[i] -= scenario.depth[i];
    leave_old_cover_on_bare_ground(scenario);
}

}  // namespace game
