#pragma once

#include <filesystem>
#include <string>

#include <tl/expected.hpp>

#include "terrains/resample.h"
#include "terrains/terrain.h"

namespace terrains {

// The scale of a heightmap, which the image does not contain.
struct HeightmapScale {
    double cell = 0;     // m from one pixel to the next, 0.001 to 10,000
    double lowest = 0;   // m, height of black, −12,000 to 9,000
    double highest = 0;  // m, height of white, above lowest, up to 9,000
};

// Reads a grey image whose brightness is height: 8, 16 or 32 bits, or float from 0 to 1, in its native type,
// so that a 16-bit image keeps its precision. Its first row is the north. It is resampled to `squares` (8 to
// 4096) along the longer side as in read_dem(); not placed on Earth, cover 0 everywhere, has_data 0 where it is
// transparent. 8
// bits give steps of 1/255 of the height range, which show as terraces on a high hill. Errors, in one
// sentence that names the file: those of read_grey_picture(), a scale or squares out of range, a grid that is
// not allowed.
tl::expected<Terrain, std::string> read_heightmap(const std::filesystem::path& path,
                                                  const HeightmapScale& scale, const GridChoice& choice);

}  // namespace terrains
