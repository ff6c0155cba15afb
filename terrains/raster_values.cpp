#include "terrains/raster_values.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <optional>
#include <string_view>
#include <utility>

#include <cpl_string.h>
#include <fmt/format.h>

#include "terrains/limits.h"
#include "terrains/lower_case.h"
#include "terrains/raster_system.h"
#include "terrains/raster_text.h"

namespace terrains {
namespace {

using Done = tl::expected<void, std::string>;

// Words and range of a quantity; m, or 1 of a share.
struct Bounds {
    const char* noun;  // "heights"
    const char* is;    // "m high"
    double lowest, highest;
    double overshoot;  // by which a resampling may exceed them
    std::uint64_t most_pixels;
};

const Bounds& bounds_of(Quantity quantity) {
    static constexpr std::array<Bounds, 3> kBounds{
        Bounds{"heights", "m high", kLowestGround, kHighestGround, 0, kMostDemPixels},
        Bounds{"depths", "m deep", -200, 200, 0, kMostDepthPixels},
        Bounds{"shares", "of a wood", 0, 1, 0.1, kMostDemPixels},
    };
    return kBounds[static_cast<std::size_t>(quantity)];
}

// Reserves cache for GDAL, which decompresses whole blocks. A row of the raster needs all blocks that it
// crosses.
Done check_blocks(GDALDatasetH dataset) {
    constexpr std::int64_t kMostBytes = std::int64_t{512} << 20;
    constexpr std::int64_t kUsualBytes = std::int64_t{64} << 20;
    GDALRasterBandH band = GDALGetRasterBand(dataset, 1);
    int across = 0, down = 0;
    GDALGetBlockSize(band, &across, &down);
    const auto blocks = (GDALGetRasterXSize(dataset) + std::int64_t{across} - 1) / across;
    const std::int64_t most = blocks * across * down * GDALGetDataTypeSizeBytes(GDALGetRasterDataType(band));
    if (most > kMostBytes)
        return tl::unexpected(fmt::format(
            "one row of its blocks takes {} MiB, and the most is {}; rewrite it in tiles of 512 pixels",
            most >> 20, kMostBytes >> 20));
    GDALSetCacheMax64(kUsualBytes + most + most / 2);  // includes their masks
    return {};
}

// Before pixels are read.
Done check_size(GDALDatasetH dataset, std::uint64_t most_pixels) {
    const int width = GDALGetRasterXSize(dataset), height = GDALGetRasterYSize(dataset);
    if (width < 2 || height < 2 || width > kMostDemSide || height > kMostDemSide ||
        static_cast<std::uint64_t>(width) * static_cast<std::uint64_t>(height) > most_pixels)
        return tl::unexpected(
            fmt::format("{} × {} pixels; a raster has 2 to {} along each side and at most {} million in all",
                        width, height, kMostDemSide, most_pixels / 1'000'000));
    return check_blocks(dataset);
}

// A photo, a map of colours or of classes is read by GDAL as any other raster.
Done check_colours(GDALDatasetH dataset, const char* noun) {
    const auto colour_of = [dataset](int band) {
        return GDALGetRasterColorInterpretation(GDALGetRasterBand(dataset, band));
    };
    const int bands = GDALGetRasterCount(dataset);
    GDALRasterBandH first = GDALGetRasterBand(dataset, 1);
    const GDALColorInterp colour = colour_of(1);
    if (colour == GCI_PaletteIndex)
        return tl::unexpected(fmt::format("its values are numbers of a palette of colours, not {}", noun));
    if (colour != GCI_GrayIndex && colour != GCI_Undefined)
        return tl::unexpected(fmt::format(
            "its first band is {} of an image, not {}; {} that are coded as colours (terrain-RGB) must be "
            "decoded first",
            GDALGetColorInterpretationName(colour), noun, noun));
    char** classes = GDALGetRasterCategoryNames(first);
    const char* layer = GDALGetMetadataItem(first, "LAYER_TYPE", nullptr);
    if (CSLCount(classes) > 0 || (layer != nullptr && std::string_view(layer) == "thematic"))
        return tl::unexpected(fmt::format("its values are numbers of classes, not {}", noun));
    int bytes = 0;
    for (int band = 1; band <= bands; ++band)
        if (colour_of(band) != GCI_AlphaBand &&
            GDALGetRasterDataType(GDALGetRasterBand(dataset, band)) == GDT_Byte)
            ++bytes;
    if (bytes >= 3)
        return tl::unexpected(
            fmt::format("it has {} bands of 8 bits, as an image in colour has, not {}", bytes, noun));
    return {};
}

struct Unit {
    const char* name;  // in lower case
    double metres;
};
constexpr double kFoot = 0.3048, kSurveyFoot = 1200.0 / 3937.0;
constexpr std::array kUnits{
    Unit{"m", 1},
    Unit{"metre", 1},
    Unit{"metres", 1},
    Unit{"meter", 1},
    Unit{"meters", 1},
    Unit{"mm", 0.001},
    Unit{"millimetre", 0.001},
    Unit{"millimeter", 0.001},
    Unit{"millimetres", 0.001},
    Unit{"millimeters", 0.001},
    Unit{"cm", 0.01},
    Unit{"centimetre", 0.01},
    Unit{"centimeter", 0.01},
    Unit{"centimetres", 0.01},
    Unit{"centimeters", 0.01},
    Unit{"dm", 0.1},
    Unit{"decimetre", 0.1},
    Unit{"decimeter", 0.1},
    Unit{"decimetres", 0.1},
    Unit{"decimeters", 0.1},
    Unit{"km", 1000},
    Unit{"kilometre", 1000},
    Unit{"kilometer", 1000},
    Unit{"ft", kFoot},
    Unit{"foot", kFoot},
    Unit{"feet", kFoot},
    Unit{"international foot", kFoot},
    Unit{"us survey foot", kSurveyFoot},
    Unit{"us survey feet", kSurveyFoot},
    Unit{"us-ft", kSurveyFoot},
    Unit{"ftus", kSurveyFoot},
    Unit{"sft", kSurveyFoot},
    Unit{"foot_us", kSurveyFoot},
};

tl::expected<double, std::string> metres_per_unit(std::string_view unit, const char* noun) {
    const std::string lower = lower_case(unit);
    for (const Unit& known : kUnits)
        if (lower == known.name) return known.metres;
    return tl::unexpected(fmt::format("its {} are in '{}', which is neither metres nor feet", noun, unit));
}

// How many metres one of its numbers is; of a share, how many 1.
tl::expected<double, std::string> unit_of(const Raster& raster, Quantity quantity) {
    const std::string_view unit = GDALGetRasterUnitType(GDALGetRasterBand(raster.get(), 1));
    const char* noun = bounds_of(quantity).noun;
    if (quantity == Quantity::kShare) {
        if (unit.empty() || unit == "1") return 1.0;
        if (unit == "%") return 0.01;
        return tl::unexpected(fmt::format("its {} are in '{}', which is neither 1 nor %", noun, unit));
    }
    const auto system = system_of(raster);
    if (!system) return tl::unexpected(system.error());
    if (system->counts_down)
        return tl::unexpected<std::string>(
            "its vertical system counts downwards from a level; convert it to heights");
    if (!unit.empty()) return metres_per_unit(unit, noun);
    return system->metres_per_height;
}

// A virtual raster reads its texts by GDAL alone, so their words are checked here.
Done check_sources(const Raster& raster) {
    for (const auto& file : raster.files()) {
        const Dataset source(
            GDALOpenEx(file.c_str(), GDAL_OF_RASTER | GDAL_OF_READONLY, nullptr, nullptr, nullptr));
        if (!source) continue;  // not a raster, but a part of one
        const auto voids = check_words(source.get(), file);
        const std::string name = file.filename().string();
        if (!voids) return tl::unexpected(fmt::format("{}: {}", name, voids.error()));
        if (!voids->empty())
            return tl::unexpected(
                fmt::format("{}: it has words for no data, which a virtual raster reads as 0", name));
    }
    return {};
}

}  // namespace

tl::expected<RasterValues, std::string> RasterValues::open(const Raster& raster, Quantity quantity) {
    GDALDatasetH dataset = raster.get();
    const Bounds& bounds = bounds_of(quantity);
    if (auto bounded = check_size(dataset, bounds.most_pixels); !bounded)
        return tl::unexpected(bounded.error());
    if (auto grey = check_colours(dataset, bounds.noun); !grey) return tl::unexpected(grey.error());
    RasterValues values;
    values.quantity_ = quantity;
    if (auto opened = values.open_band(raster); !opened) return tl::unexpected(opened.error());
    auto voids = check_words(dataset, raster.path());
    if (!voids) return tl::unexpected(voids.error());
    values.voids_ = std::move(*voids);
    if (std::string_view(GDALGetDriverShortName(GDALGetDatasetDriver(dataset))) == "VRT")
        if (auto sound = check_sources(raster); !sound) return tl::unexpected(sound.error());
    return values;
}

Done RasterValues::open_band(const Raster& raster) {
    GDALDatasetH dataset = raster.get();
    const char* noun = bounds_of(quantity_).noun;
    columns_ = GDALGetRasterXSize(dataset);
    rows_ = GDALGetRasterYSize(dataset);
    band_ = GDALGetRasterBand(dataset, 1);
    if (GDALDataTypeIsComplex(GDALGetRasterDataType(band_)) != 0)
        return tl::unexpected(fmt::format("its values are complex numbers, not {}", noun));
    const auto unit = unit_of(raster, quantity_);
    if (!unit) return tl::unexpected(unit.error());
    scale_ = GDALGetRasterScale(band_, nullptr) * *unit;
    offset_ = GDALGetRasterOffset(band_, nullptr) * *unit;
    if (!std::isfinite(scale_ + offset_) || scale_ == 0)
        return tl::unexpected(
            fmt::format("its scale is {} and its offset {}, so it has no {}", scale_, offset_, noun));

    const int flags = GDALGetMaskFlags(band_);
    if ((flags & GMF_ALL_VALID) == 0) mask_ = GDALGetMaskBand(band_);
    int stated = 0;
    no_data_ = static_cast<float>(GDALGetRasterNoDataValue(band_, &stated));
    has_no_data_ = stated != 0 && (flags & GMF_NODATA) == 0;
    // GDAL takes an alpha band for a mask only if it has 8 or 16 bits, and no value stands for no data.
    for (int i = 2; i <= GDALGetRasterCount(dataset); ++i)
        if (GDALRasterBandH other = GDALGetRasterBand(dataset, i);
            GDALGetRasterColorInterpretation(other) == GCI_AlphaBand)
            alpha_ = other;
    known_.resize(static_cast<std::size_t>(columns_), 255);
    opacity_.resize(static_cast<std::size_t>(columns_), 1);

    GDALGetBlockSize(band_, &block_width_, &block_height_);
    may_miss_blocks_ = mask_ == nullptr &&
                       std::string_view(GDALGetDriverShortName(GDALGetDatasetDriver(dataset))) == "GTiff";
    return {};
}

// A TIFF may leave out blocks, which GDAL reads as 0.
void RasterValues::find_missing_blocks(int row) {
    if (!may_miss_blocks_ || row / block_height_ == block_row_) return;
    block_row_ = row / block_height_;
    missing_.clear();
    const int top = block_row_ * block_height_, height = std::min(block_height_, rows_ - top);
    for (int left = 0; left < columns_; left += block_width_)
        missing_.push_back(GDALGetDataCoverageStatus(band_, left, top,
                                                     std::min(block_width_, columns_ - left), height, 0,
                                                     nullptr) == GDAL_DATA_COVERAGE_STATUS_EMPTY);
}

bool RasterValues::is_unknown(int row, int column, double stored) const {
    const auto i = static_cast<std::size_t>(column);
    return known_[i] == 0 || !(opacity_[i] > 0) || std::isnan(stored) || stored == -9999 ||
           stored == -32768 || (has_no_data_ && static_cast<float>(stored) == no_data_) ||
           (!missing_.empty() && missing_[i / static_cast<std::size_t>(block_width_)]) ||
           (!voids_.empty() &&
            voids_[static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) + i]);
}

Done RasterValues::read(int row, std::vector<double>& values) {
    const GdalErrors errors;
    values.resize(static_cast<std::size_t>(columns_));
    const auto fill = [&](GDALRasterBandH band, void* into, GDALDataType type) {
        return band == nullptr ||
               GDALRasterIO(band, GF_Read, 0, row, columns_, 1, into, columns_, 1, type, 0, 0) == CE_None;
    };
    const bool done = fill(band_, values.data(), GDT_Float64) && fill(mask_, known_.data(), GDT_Byte) &&
                      fill(alpha_, opacity_.data(), GDT_Float64);
    if (!done || errors.any())
        return tl::unexpected(fmt::format("damaged or cut short at row {} ({})", row + 1, errors.first()));
    find_missing_blocks(row);
    const Bounds& bounds = bounds_of(quantity_);
    for (int column = 0; column < columns_; ++column) {
        double& value = values[static_cast<std::size_t>(column)];
        if (is_unknown(row, column, value)) {
            value = std::nan("");
            continue;
        }
        value = value * scale_ + offset_;
        if (!(value >= bounds.lowest - bounds.overshoot && value <= bounds.highest + bounds.overshoot))
            return tl::unexpected(fmt::format("row {}, column {} is {} {}; {} must be {} to {}", row + 1,
                                              column + 1, value, bounds.is, bounds.noun, bounds.lowest,
                                              bounds.highest));
    }
    return {};
}

}  // namespace terrains
