#include "terrains/export.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <string_view>
#include <system_error>
#include <vector>

#include <fmt/format.h>

#include "files/whole_file.h"
#include "sim/core/check.h"
#include "terrains/geotiff.h"
#include "terrains/outlines.h"

namespace terrains {
namespace {

Written write_text(const std::filesystem::path& path, std::string_view text) {
    return files::write(path, text);
}

// The raster's rows in file order: north first, NaN as `no_data`.
std::vector<float> north_first(const sim::Grid& grid, std::span<const float> field, float no_data) {
    std::vector<float> rows;
    rows.reserve(field.size());
    for (int y = grid.ny - 1; y >= 0; --y)
        for (int x = 0; x < grid.nx; ++x) {
            const float value = field[static_cast<std::size_t>(y) * grid.nx + x];
            rows.push_back(std::isnan(value) ? no_data : value);
        }
    return rows;
}

}  // namespace

Written write_geotiff(const std::filesystem::path& path, const sim::Grid& grid,
                      const Georeference& georeference, std::span<const float> field) {
    CHECK(field.size() == grid.size());
    const auto bytes = encode_geotiff(grid, georeference, north_first(grid, field, kNoDataWritten));
    if (!bytes) return tl::unexpected(fmt::format("{}: cannot be written: {}", path.string(), bytes.error()));
    return files::write(path, *bytes);
}

Written write_ascii(const std::filesystem::path& path, const sim::Grid& grid,
                    const Georeference& georeference, std::span<const float> field, AsciiStyle style) {
    CHECK(field.size() == grid.size());
    const bool centred = style == AsciiStyle::kCentred;
    const double cell = grid.dx, half = centred ? cell / 2 : 0;
    std::string text =
        fmt::format("ncols {}\nnrows {}\nxll{} {}\nyll{} {}\ncellsize {}\n", grid.nx, grid.ny,
                    centred ? "center" : "corner", west_edge(grid, georeference) + half,
                    centred ? "center" : "corner", south_edge(grid, georeference) + half, cell);
    const float no_data = centred ? std::numeric_limits<float>::quiet_NaN() : kNoDataWritten;
    text += fmt::format("NODATA_value {}\n", no_data);
    const std::vector<float> rows = north_first(grid, field, no_data);
    // GDAL takes a line that begins with a letter for one of the header.
    if (std::isnan(rows.front())) text += ' ';
    for (std::size_t i = 0; i < rows.size(); ++i)
        fmt::format_to(std::back_inserter(text), "{}{}", rows[i], (i + 1) % grid.nx == 0 ? '\n' : ' ');
    const std::filesystem::path prj = std::filesystem::path(path).replace_extension(".prj");
    if (georeference.placed()) {
        if (auto written = write_text(prj, esri_wkt(georeference.wkt())); !written) return written;
    } else {
        std::error_code absent;
        std::filesystem::remove(prj, absent);
    }
    return write_text(path, text);
}

Written write_outlines(const std::filesystem::path& path, const sim::Grid& grid,
                       const Georeference& georeference, std::span<const std::uint8_t> mask) {
    CHECK(mask.size() == grid.size());
    const auto text = outlines_of(grid, georeference, mask);
    if (!text) return tl::unexpected(fmt::format("{}: {}", path.string(), text.error()));
    return write_text(path, *text);
}

Written write_areas(const std::filesystem::path& path, const sim::Grid& grid,
                    const Georeference& georeference, std::span<const int> patch,
                    std::span<const Properties> properties) {
    CHECK(patch.size() == grid.size());
    const auto text = outlines_of(grid, georeference, patch, properties);
    if (!text) return tl::unexpected(fmt::format("{}: {}", path.string(), text.error()));
    return write_text(path, *text);
}

}  // namespace terrains
