#include "terrains/heightmap_image.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "terrains/grey_picture.h"
#include "terrains/resample.h"

namespace terrains {
namespace {

using Done = tl::expected<void, std::string>;

Done check_scale(const HeightmapScale& scale) {
    if (!(scale.cell >= 0.001 && scale.cell <= 10'000))
        return tl::unexpected(fmt::format("a pixel of {} m; it must be 0.001 to 10000 m", scale.cell));
    if (!(scale.lowest >= -12'000 && scale.highest > scale.lowest && scale.highest <= 9'000))
        return tl::unexpected(fmt::format("heights from {} to {} m; they must rise, within -12000 to 9000 m",
                                          scale.lowest, scale.highest));
    return {};
}

tl::expected<Terrain, std::string> terrain_of(const GreyPicture& picture, const HeightmapScale& scale,
                                              const GridChoice& choice) {
    const int width = picture.width, height = picture.height;
    const auto grid = grid_over((width - 1) * scale.cell, (height - 1) * scale.cell, choice);
    if (!grid) return tl::unexpected(grid.error());
    const double reach = std::max<double>(grid->dx, scale.cell);
    PlaneFit fit(*grid, reach, reach, scale.cell * scale.cell);
    for (int row = 0; row < height; ++row)
        for (int column = 0; column < width; ++column) {
            const double share = picture.brightness[static_cast<std::size_t>(row) * width + column];
            const double x = column * scale.cell, y = (height - 1 - row) * scale.cell;
            if (std::isnan(share))
                fit.add_void(x, y);
            else
                fit.add(x, y, scale.lowest + share * (scale.highest - scale.lowest));
        }
    auto fitted = fit.finish();
    if (std::find(fitted.has_data.begin(), fitted.has_data.end(), 1) == fitted.has_data.end())
        return tl::unexpected<std::string>("its opaque pixels cover no vertex, so the terrain has no ground");
    Terrain terrain;
    terrain.licence = picture.licence;
    terrain.grid = *grid;
    terrain.surface = std::move(fitted.surface);
    terrain.has_data = std::move(fitted.has_data);
    terrain.cover.assign(grid->size(), 0.f);
    fill_voids(terrain.grid, terrain.has_data, terrain.surface);
    return terrain;
}

}  // namespace

tl::expected<Terrain, std::string> read_heightmap(const std::filesystem::path& path,
                                                  const HeightmapScale& scale, const GridChoice& choice) {
    const auto said = [&path](const std::string& fact) {
        return tl::unexpected(fmt::format("{}: {}", path.string(), fact));
    };
    if (auto right = check_scale(scale); !right) return said(right.error());
    const auto picture = read_grey_picture(path);
    if (!picture) return tl::unexpected(picture.error());
    auto terrain = terrain_of(*picture, scale, choice);
    if (!terrain) return said(terrain.error());
    terrain->name = path.filename().string();
    return terrain;
}

}  // namespace terrains
