#include "terrains/release.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "files/input.h"
#include "terrains/coverage.h"
#include "terrains/depth_raster.h"
#include "terrains/geojson.h"

namespace terrains {
namespace {

// How much thicker a layer at a vertex is vertically than normal to the slope: 1/cosθ. Where there is no data, the
// surface extends its neighbours' slope.
double vertical_per_normal(const Terrain& terrain, int x, int y) {
    const sim::Grid& grid = terrain.grid;
    const auto height = [&](int i, int j) {
        return static_cast<double>(
            terrain.surface[static_cast<std::size_t>(j) * static_cast<std::size_t>(grid.nx) +
                            static_cast<std::size_t>(i)]);
    };
    const int west = std::max(x - 1, 0), east = std::min(x + 1, grid.nx - 1);
    const int south = std::max(y - 1, 0), north = std::min(y + 1, grid.ny - 1);
    const double dx = static_cast<double>(grid.dx);
    return std::hypot(1.0, (height(east, y) - height(west, y)) / (dx * (east - west)),
                      (height(x, north) - height(x, south)) / (dx * (north - south)));
}

void make_vertical(const Terrain& terrain, std::vector<float>& normal) {
    std::size_t i = 0;
    for (int y = 0; y < terrain.grid.ny; ++y)
        for (int x = 0; x < terrain.grid.nx; ++x, ++i)
            if (normal[i] != 0)
                normal[i] =
                    static_cast<float>(static_cast<double>(normal[i]) * vertical_per_normal(terrain, x, y));
}

tl::expected<std::vector<float>, std::string> of_areas(const std::filesystem::path& path,
                                                       const Terrain& terrain) {
    auto areas = read_areas(path, terrain.georeference, ThicknessNames());
    if (!areas) return tl::unexpected(areas.error());
    const auto vertical_from =
        std::partition(areas->begin(), areas->end(), [](const Area& a) { return a.normal; });
    auto thickness = mean_thickness(terrain.grid, {areas->begin(), vertical_from});
    const auto vertical = mean_thickness(terrain.grid, {vertical_from, areas->end()});
    for (const auto* mean : {&std::as_const(thickness), &vertical})
        if (!*mean) return tl::unexpected(fmt::format("{}: {}", path.string(), mean->error()));
    make_vertical(terrain, *thickness);
    for (std::size_t i = 0; i < thickness->size(); ++i)
        (*thickness)[i] = std::max((*thickness)[i], (*vertical)[i]);
    return thickness;
}

tl::expected<std::vector<float>, std::string> of_raster(const std::filesystem::path& path,
                                                        const Terrain& terrain, Thickness measured,
                                                        References references,
                                                        std::vector<std::filesystem::path>* files) {
    auto thickness = read_depth_raster(path, terrain, references, files);
    if (thickness && measured == Thickness::kNormal) make_vertical(terrain, *thickness);
    return thickness;
}

bool empty(const std::vector<float>& thickness) {
    return std::none_of(thickness.begin(), thickness.end(), [](float t) { return t > 0; });
}

}  // namespace

tl::expected<std::vector<float>, std::string> read_release(const std::filesystem::path& path,
                                                           const Terrain& terrain,
                                                           std::optional<Thickness> measured,
                                                           References references,
                                                           std::vector<std::filesystem::path>* files) {
    if (files != nullptr) *files = {path};
    if (auto is_file = files::check_input(path); !is_file) return tl::unexpected(is_file.error());
    const bool areas = looks_like_json(path);
    if (areas && measured)
        return tl::unexpected(
            fmt::format("{}: its features say how they are measured, by thickness or thickness_normal; leave "
                        "--thickness out",
                        path.string()));
    auto thickness =
        areas ? of_areas(path, terrain)
              : of_raster(path, terrain, measured.value_or(Thickness::kVertical), references, files);
    if (!thickness) return thickness;
    for (std::size_t i = 0; i < thickness->size(); ++i)
        if (terrain.has_data[i] == 0) (*thickness)[i] = 0;
    if (empty(*thickness))
        return tl::unexpected(fmt::format("{}: it covers no ground of {}", path.string(), terrain.name));
    return thickness;
}

tl::expected<std::vector<std::uint8_t>, std::string> read_extent(const std::filesystem::path& path,
                                                                 const Terrain& terrain) {
    auto areas = read_areas(path, terrain.georeference, std::nullopt);
    if (!areas) return tl::unexpected(areas.error());
    for (Area& area : *areas) area.thickness = 1;  // so that the mean thickness is the share covered
    const auto share = mean_thickness(terrain.grid, *areas);
    if (!share) return tl::unexpected(fmt::format("{}: {}", path.string(), share.error()));
    if (empty(*share))
        return tl::unexpected(fmt::format("{}: none of its polygons covers {}", path.string(), terrain.name));
    std::vector<std::uint8_t> mask(share->size());
    std::transform(share->begin(), share->end(), mask.begin(), [](float s) { return s >= 0.5f ? 1 : 0; });
    return mask;
}

tl::expected<Reference, std::string> read_reference(const std::filesystem::path& path, const Terrain& terrain,
                                                    References references) {
    if (auto is_file = files::check_input(path); !is_file) return tl::unexpected(is_file.error());
    Reference reference;
    reference.files = {path};
    if (looks_like_json(path)) {
        auto extent = read_extent(path, terrain);
        if (!extent) return tl::unexpected(extent.error());
        reference.extent = std::move(*extent);
    } else {
        auto change = read_signed_raster(path, terrain, references, &reference.files);
        if (!change) return tl::unexpected(change.error());
        if (std::all_of(change->begin(), change->end(), [](float metres) { return metres == 0; }))
            return tl::unexpected(
                fmt::format("{}: it has no height change on {}", path.string(), terrain.name));
        reference.change = std::move(*change);
    }
    return reference;
}

}  // namespace terrains
