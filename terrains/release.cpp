#include "terrains/release.h"

#include <algorithm>

#include <fmt/format.h>

#include "files/input.h"
#include "terrains/coverage.h"
#include "terrains/depth_raster.h"
#include "terrains/geojson.h"

namespace terrains {
namespace {

tl::expected<std::vector<float>, std::string> of_areas(const std::filesystem::path& path,
                                                       const Terrain& terrain,
                                                       std::optional<double> default_thickness) {
    const auto areas = read_areas(path, terrain.georeference, {"thickness", default_thickness});
    if (!areas) return tl::unexpected(areas.error());
    auto thickness = mean_thickness(terrain.grid, *areas);
    if (!thickness) return tl::unexpected(fmt::format("{}: {}", path.string(), thickness.error()));
    return thickness;
}

bool empty(const std::vector<float>& thickness) {
    return std::none_of(thickness.begin(), thickness.end(), [](float t) { return t > 0; });
}

}  // namespace

tl::expected<std::vector<float>, std::string> read_release(const std::filesystem::path& path,
                                                           const Terrain& terrain,
                                                           std::optional<double> default_thickness,
                                                           References references,
                                                           std::vector<std::filesystem::path>* files) {
    if (files != nullptr) *files = {path};
    if (auto is_file = files::check_input(path); !is_file) return tl::unexpected(is_file.error());
    auto thickness = looks_like_json(path) ? of_areas(path, terrain, default_thickness)
                                           : read_depth_raster(path, terrain, references, files);
    if (!thickness) return thickness;
    for (std::size_t i = 0; i < thickness->size(); ++i)
        if (terrain.has_data[i] == 0) (*thickness)[i] = 0;
    if (empty(*thickness))
        return tl::unexpected(fmt::format("{}: it covers no ground of {}", path.string(), terrain.name));
    return thickness;
}

tl::expected<std::vector<std::uint8_t>, std::string> read_extent(const std::filesystem::path& path,
                                                                 const Terrain& terrain) {
    auto areas = read_areas(path, terrain.georeference, {});
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
