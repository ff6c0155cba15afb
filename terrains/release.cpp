#include "terrains/release.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include <fmt/format.h>

#include "files/input.h"
#include "terrains/coverage.h"
#include "terrains/depth_raster.h"
#include "terrains/geojson.h"
#include "terrains/polygon_file.h"

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
    const double along_x = (height(east, y) - height(west, y)) / (dx * (east - west)),
                 along_y = (height(x, north) - height(x, south)) / (dx * (north - south));
    return std::sqrt(1 + along_x * along_x +
                     along_y * along_y);  // the same bits with every mathematics library
}

double volume(const Terrain& terrain, const std::vector<float>& thickness) {
    const double dx = static_cast<double>(terrain.grid.dx);
    return std::accumulate(thickness.begin(), thickness.end(), 0.0) * dx * dx;
}

// Returns how many times the volume is then, 1 if there is none.
double make_vertical(const Terrain& terrain, std::vector<float>& normal) {
    const double before = volume(terrain, normal);
    std::size_t i = 0;
    for (int y = 0; y < terrain.grid.ny; ++y)
        for (int x = 0; x < terrain.grid.nx; ++x, ++i)
            if (normal[i] != 0)
                normal[i] =
                    static_cast<float>(static_cast<double>(normal[i]) * vertical_per_normal(terrain, x, y));
    return before > 0 ? volume(terrain, normal) / before : 1;
}

// What some areas release, all measured in one way.
tl::expected<Release, std::string> cover_ground(const Terrain& terrain, const std::vector<Area>& areas,
                                                Thickness measured) {
    Release release;
    auto coverage = cover(terrain.grid, areas);
    if (!coverage) return tl::unexpected(coverage.error());
    release.thickness = std::move(coverage->mean);
    const double vertical_per_measured =
        measured == Thickness::kNormal ? make_vertical(terrain, release.thickness) : 1;
    for (const Area& area : areas) {
        const double per_area = area.thickness * vertical_per_measured, whole = area_of(area);
        release.volumes.in_file += whole * per_area;
        release.volumes.outside += std::max(whole - area_on_grid(area, terrain.grid), 0.0) * per_area;
    }
    release.volumes.overlap = coverage->overlap * vertical_per_measured;
    return release;
}

// The polygons of a file.
struct MeasuredAreas {
    std::vector<Area> areas;
    std::size_t without_geometry = 0;
};
tl::expected<MeasuredAreas, std::string> measured_areas(const std::filesystem::path& path,
                                                        const Terrain& terrain,
                                                        std::optional<Thickness> measured) {
    const ThicknessNames names{.both_normal = measured == Thickness::kNormal};
    auto read = read_areas(path, terrain.georeference, names);
    if (!read) return tl::unexpected(read.error());
    if (measured == Thickness::kVertical && std::ranges::any_of(read->areas, &Area::normal))
        return tl::unexpected(fmt::format("{}: it has '{}', which is not vertical; leave --thickness out",
                                          path.string(), names.normal));
    return MeasuredAreas{std::move(read->areas), read->without_geometry};
}

tl::expected<Release, std::string> of_areas(const std::filesystem::path& path, const Terrain& terrain,
                                            std::optional<Thickness> measured) {
    auto read = measured_areas(path, terrain, measured);
    if (!read) return tl::unexpected(read.error());
    std::vector<Area>& areas = read->areas;
    const auto vertical_from =
        std::partition(areas.begin(), areas.end(), [](const Area& a) { return a.normal; });
    auto release = cover_ground(terrain, {areas.begin(), vertical_from}, Thickness::kNormal);
    const auto vertical = cover_ground(terrain, {vertical_from, areas.end()}, Thickness::kVertical);
    for (const auto* one : {&std::as_const(release), &vertical})
        if (!*one) return tl::unexpected(fmt::format("{}: {}", path.string(), one->error()));
    release->normal = vertical_from != areas.begin();
    release->vertical = vertical_from != areas.end();
    ReleaseVolumes& volumes = release->volumes;
    const double apart = volume(terrain, release->thickness) + volume(terrain, vertical->thickness);
    std::transform(release->thickness.begin(), release->thickness.end(), vertical->thickness.begin(),
                   release->thickness.begin(), [](float a, float b) { return std::max(a, b); });
    volumes.in_file += vertical->volumes.in_file;
    volumes.outside += vertical->volumes.outside;
    volumes.overlap += vertical->volumes.overlap + (apart - volume(terrain, release->thickness));
    release->without_geometry = read->without_geometry;
    release->files = {path};
    return release;
}

// The file as a raster, or, if its beginning is that of polygons, what to do with them.
template <class Read>
auto raster_or_advice(const std::filesystem::path& path, Read read) {
    auto raster = read();
    if (!raster)
        if (const auto advice = advice_on_polygons(path)) raster = tl::unexpected(*advice);
    return raster;
}

tl::expected<Release, std::string> of_raster(const std::filesystem::path& path, const Terrain& terrain,
                                             Thickness measured, References references) {
    auto depths = raster_or_advice(path, [&] { return read_depth_raster(path, terrain, references); });
    if (!depths) return tl::unexpected(depths.error());
    Release release;
    release.files = std::move(depths->files);
    release.thickness = std::move(depths->mean);
    release.volumes.in_file = depths->in_file;
    release.volumes.outside = depths->outside;
    release.normal = measured == Thickness::kNormal;
    release.vertical = !release.normal;
    if (release.vertical) return release;
    const double vertical_per_measured = make_vertical(terrain, release.thickness);
    release.volumes.in_file *= vertical_per_measured;
    release.volumes.outside *= vertical_per_measured;
    return release;
}

// Of a polygon by itself: costs what the part of the grid around it costs.
tl::expected<ReleasePatch, std::string> patch_of(Area area, const Terrain& terrain) {
    const sim::Grid& grid = terrain.grid;
    const double dx = grid.dx;
    LocalPoint least = area.rings.front().front(), most = least;
    for (const std::vector<LocalPoint>& ring : area.rings)
        for (const LocalPoint& point : ring) {
            least = {std::min(least.x, point.x), std::min(least.y, point.y)};
            most = {std::max(most.x, point.x), std::max(most.y, point.y)};
        }
    // Its vertices, with one more on each side.
    const auto vertex = [dx](double metres, int beyond, int end) {
        return static_cast<int>(
            std::clamp(std::floor(metres / dx) + beyond, 0.0, static_cast<double>(end - 1)));
    };
    const int x0 = vertex(least.x, -1, grid.nx), x1 = vertex(most.x, 2, grid.nx);
    const int y0 = vertex(least.y, -1, grid.ny), y1 = vertex(most.y, 2, grid.ny);
    for (std::vector<LocalPoint>& ring : area.rings)
        for (LocalPoint& point : ring) point = {point.x - x0 * dx, point.y - y0 * dx};
    const sim::Grid window{x1 - x0 + 1, y1 - y0 + 1, grid.dx};
    const auto coverage = cover(window, {area});
    if (!coverage) return tl::unexpected(coverage.error());

    ReleasePatch patch;
    std::size_t i = 0;
    for (int y = y0; y <= y1; ++y)
        for (int x = x0; x <= x1; ++x, ++i) {
            const std::size_t at =
                static_cast<std::size_t>(y) * static_cast<std::size_t>(grid.nx) + static_cast<std::size_t>(x);
            if (coverage->mean[i] == 0 || terrain.has_data[at] == 0) continue;
            const double vertical = area.normal ? vertical_per_normal(terrain, x, y) : 1;
            patch.vertices.push_back(static_cast<std::uint32_t>(at));
            patch.thickness.push_back(static_cast<float>(static_cast<double>(coverage->mean[i]) * vertical));
            patch.volume += static_cast<double>(patch.thickness.back()) * grid.cell_area();
        }
    return patch;
}

bool empty(const std::vector<float>& thickness) {
    return std::none_of(thickness.begin(), thickness.end(), [](float t) { return t > 0; });
}

tl::expected<Reference, std::string> read_extent(const std::filesystem::path& path, const Terrain& terrain) {
    auto read = read_areas(path, terrain.georeference, std::nullopt);
    if (!read) return tl::unexpected(read.error());
    Reference reference;
    for (Area& area : read->areas) {
        area.thickness = 1;  // so that the mean thickness is the share covered
        const double whole = area_of(area);
        reference.in_file += whole;
        reference.outside += std::max(whole - area_on_grid(area, terrain.grid), 0.0);
    }
    const auto coverage = cover(terrain.grid, read->areas);
    if (!coverage) return tl::unexpected(fmt::format("{}: {}", path.string(), coverage.error()));
    const std::vector<float>& share = coverage->mean;
    if (empty(share))
        return tl::unexpected(fmt::format("{}: none of its polygons covers {}", path.string(), terrain.name));
    reference.extent.resize(share.size());
    std::transform(share.begin(), share.end(), reference.extent.begin(),
                   [](float s) { return s >= 0.5f ? 1 : 0; });
    reference.without_geometry = read->without_geometry;
    reference.files = {path};
    return reference;
}

}  // namespace

tl::expected<Release, std::string> read_release(const std::filesystem::path& path, const Terrain& terrain,
                                                std::optional<Thickness> measured, References references) {
    if (auto is_file = files::check_input(path); !is_file) return tl::unexpected(is_file.error());
    auto release = looks_like_json(path)
                       ? of_areas(path, terrain, measured)
                       : of_raster(path, terrain, measured.value_or(Thickness::kVertical), references);
    if (!release) return release;
    const double on_grid = volume(terrain, release->thickness);
    for (std::size_t i = 0; i < release->thickness.size(); ++i)
        if (terrain.has_data[i] == 0) release->thickness[i] = 0;
    if (empty(release->thickness))
        return tl::unexpected(fmt::format("{}: it covers no ground of {}", path.string(), terrain.name));
    release->volumes.on_ground = volume(terrain, release->thickness);
    release->volumes.on_no_data = on_grid - release->volumes.on_ground;
    return release;
}

tl::expected<std::vector<ReleasePatch>, std::string> read_release_patches(const std::filesystem::path& path,
                                                                          const Terrain& terrain,
                                                                          std::optional<Thickness> measured) {
    if (auto is_file = files::check_input(path); !is_file) return tl::unexpected(is_file.error());
    if (!looks_like_json(path))
        return tl::unexpected(
            fmt::format("{}: it has no polygons that could be released one at a time", path.string()));
    const auto read = measured_areas(path, terrain, measured);
    if (!read) return tl::unexpected(read.error());
    std::vector<ReleasePatch> patches;
    for (const Area& area : read->areas) {
        auto patch = patch_of(area, terrain);
        if (!patch) return tl::unexpected(fmt::format("{}: {}", path.string(), patch.error()));
        patches.push_back(std::move(*patch));
    }
    return patches;
}

tl::expected<Reference, std::string> read_reference(const std::filesystem::path& path, const Terrain& terrain,
                                                    References references) {
    if (auto is_file = files::check_input(path); !is_file) return tl::unexpected(is_file.error());
    if (looks_like_json(path)) return read_extent(path, terrain);
    auto change = raster_or_advice(path, [&] { return read_signed_raster(path, terrain, references); });
    if (!change) return tl::unexpected(change.error());
    if (std::all_of(change->mean.begin(), change->mean.end(), [](float metres) { return metres == 0; }))
        return tl::unexpected(fmt::format("{}: it has no height change on {}", path.string(), terrain.name));
    Reference reference;
    reference.change = std::move(change->mean);
    reference.in_file = change->in_file;
    reference.outside = change->outside;
    reference.files = std::move(change->files);
    return reference;
}

}  // namespace terrains
