#include "terrains/heightmap_image.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

#include <OpenImageIO/imageio.h>
#include <fmt/format.h>

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

Done check_picture(const OIIO::ImageSpec& spec) {
    constexpr double kMostPixels = 100e6;
    if (spec.width < 2 || spec.height < 2 || static_cast<double>(spec.width) * spec.height > kMostPixels)
        return tl::unexpected(
            fmt::format("{} × {} pixels: a heightmap has at least 2 each way and at most 100 million",
                        spec.width, spec.height));
    if (spec.nchannels > 2)
        return tl::unexpected(fmt::format("{} channels; a heightmap is grey", spec.nchannels));
    if (spec.format == OIIO::TypeDesc::HALF)
        return tl::unexpected<std::string>("half floats, which are metres off at a mountain's height");
    return {};
}

// The first channel of every pixel as 0 to 1, from the type in which the file keeps it.
template <class Stored>
Done read_as(OIIO::ImageInput& input, std::vector<float>& brightness) {
    const OIIO::ImageSpec& spec = input.spec();
    std::vector<Stored> pixels(static_cast<std::size_t>(spec.width) * spec.height);
    if (!input.read_image(0, 0, 0, 1, OIIO::BaseTypeFromC<Stored>::value, pixels.data()))
        return tl::unexpected(fmt::format("damaged or cut short ({})", input.geterror()));
    brightness.resize(pixels.size());
    for (std::size_t i = 0; i < pixels.size(); ++i) {
        double value = static_cast<double>(pixels[i]);
        if constexpr (std::numeric_limits<Stored>::is_integer) value /= std::numeric_limits<Stored>::max();
        if (!(value >= 0 && value <= 1))
            return tl::unexpected(fmt::format("row {}, column {} is {}, and brightness is 0 to 1",
                                              i / spec.width + 1, i % spec.width + 1, value));
        brightness[i] = static_cast<float>(value);
    }
    return {};
}

Done read_brightness(OIIO::ImageInput& input, std::vector<float>& brightness) {
    switch (input.spec().format.basetype) {
        case OIIO::TypeDesc::UINT8:
            return read_as<std::uint8_t>(input, brightness);
        case OIIO::TypeDesc::UINT16:
            return read_as<std::uint16_t>(input, brightness);
        case OIIO::TypeDesc::UINT32:
            return read_as<std::uint32_t>(input, brightness);
        case OIIO::TypeDesc::FLOAT:
            return read_as<float>(input, brightness);
        default:
            return tl::unexpected(fmt::format("pixels of type {}; a heightmap has 8, 16 or 32 bits or floats",
                                              input.spec().format.c_str()));
    }
}

tl::expected<Terrain, std::string> read(OIIO::ImageInput& input, const HeightmapScale& scale, int squares) {
    const int width = input.spec().width, height = input.spec().height;
    std::vector<float> brightness;
    if (auto fits = check_picture(input.spec()); !fits) return tl::unexpected(fits.error());
    const auto grid = grid_over((width - 1) * scale.cell, (height - 1) * scale.cell, squares);
    if (!grid) return tl::unexpected(grid.error());
    if (auto done = read_brightness(input, brightness); !done) return tl::unexpected(done.error());
    const double reach = std::max<double>(grid->dx, scale.cell);
    PlaneFit fit(*grid, reach, reach, scale.cell * scale.cell);
    for (int row = 0; row < height; ++row)
        for (int column = 0; column < width; ++column) {
            const double share = brightness[static_cast<std::size_t>(row) * width + column];
            fit.add(column * scale.cell, (height - 1 - row) * scale.cell,
                    scale.lowest + share * (scale.highest - scale.lowest));
        }
    auto fitted = fit.finish();
    Terrain terrain;
    terrain.licence = input.spec().get_string_attribute("Copyright");
    terrain.grid = *grid;
    terrain.surface = std::move(fitted.surface);
    terrain.has_data = std::move(fitted.has_data);
    terrain.cover.assign(grid->size(), 0.f);
    return terrain;
}

}  // namespace

tl::expected<Terrain, std::string> read_heightmap(const std::filesystem::path& path,
                                                  const HeightmapScale& scale, int squares) {
    const auto said = [&path](const std::string& fact) {
        return tl::unexpected(fmt::format("{}: {}", path.string(), fact));
    };
    if (auto right = check_scale(scale); !right) return said(right.error());
    std::error_code status;
    if (!std::filesystem::exists(path, status)) return said("there is no such file");
    const auto input = OIIO::ImageInput::open(path.string());
    if (!input) return said(fmt::format("not a picture that can be read ({})", OIIO::geterror()));
    auto terrain = read(*input, scale, squares);
    if (!terrain) return said(terrain.error());
    terrain->name = path.filename().string();
    return terrain;
}

}  // namespace terrains
