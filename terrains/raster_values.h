#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <gdal.h>
#include <tl/expected.hpp>

#include "terrains/gdal_support.h"
#include "terrains/quantity.h"

namespace terrains {

// The only reader of a raster's pixels: what it returns are metres (of a share, 1) or unknown, for every format and every
// use. Include it from sources only, because GDAL's types are in it. The test `Rasters.are_read_in_one_place` finds
// other callers of GDAL's pixels.
//
// Value. The number in the first band × scale + offset, as the file states them, in its unit: the band's, else that of
// the vertical coordinate system: metres if neither is stated; mm, cm, dm, m, km and feet, international or US survey.
// Another unit is refused. A share has no unit or %.
//
// Unknown. NaN; what the file declares by a value, a mask, an alpha of 0 or a missing block; always −9999 and −32768;
// in a text the usual words (raster_text.h).
//
// Errors, without the file's name: a size beyond the limits, complex numbers, colours (a photo, a palette, a
// terrain-RGB tile), another unit, words that are no numbers, a wrong count, damage, a value out of the range of
// its quantity, with row and column.
class RasterValues {
  public:
    static tl::expected<RasterValues, std::string> open(const Raster& raster, Quantity quantity);

    int columns() const { return columns_; }
    int rows() const { return rows_; }

    // Reads a row, 0 being the first in the file, NaN where unknown. Rows may be read in any order.
    tl::expected<void, std::string> read(int row, std::vector<double>& values);

  private:
    tl::expected<void, std::string> open_band(const Raster& raster);
    void find_missing_blocks(int row);
    bool is_unknown(int row, int column, double stored) const;

    Quantity quantity_ = Quantity::kHeight;
    int columns_ = 0, rows_ = 0;
    GDALRasterBandH band_ = nullptr, mask_ = nullptr, alpha_ = nullptr;  // null: every pixel counts
    double scale_ = 1, offset_ = 0;
    bool has_no_data_ = false;  // and the mask is another one
    float no_data_ = 0;
    std::vector<bool> voids_;  // of words, by pixel; empty: none
    bool may_miss_blocks_ = false;
    int block_width_ = 0, block_height_ = 0, block_row_ = -1;
    std::vector<bool> missing_;  // by block of block_row_
    std::vector<std::uint8_t> known_;
    std::vector<double> opacity_;
};

}  // namespace terrains
