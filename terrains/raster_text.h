#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include <gdal.h>
#include <tl/expected.hpp>

namespace terrains {

// Checks the words of a raster that is a text, because GDAL reads "NA" as 0, "1'588.00" as 1 and 40 columns as 41.
// Reads the file once, in constant memory but for the result. Other formats pass unread.
//
// ESRI ASCII, GRASS ASCII, Surfer ASCII: as many words as the header promises, each one number to its end, with
// a decimal point or throughout the file a decimal comma. Header values are numbers too.
// XYZ: in every line as many columns, and numbers in those that have one in the first line.
// USGS DEM: nothing but numbers after its first record.
//
// Returns 1 for each pixel, row by row as in the file, that ESRI or GRASS ASCII declares as no data by a word:
// NA, N/A, nan, null, nodata, *, - and the like. Empty if there are none. In other formats such a word is an error.
// Errors, without the file's name: what is no number with its row and column, or line; a wrong count.
tl::expected<std::vector<bool>, std::string> check_words(GDALDatasetH dataset,
                                                         const std::filesystem::path& path);

}  // namespace terrains
