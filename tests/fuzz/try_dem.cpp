#include "tests/fuzz/try_reader.h"

#include "terrains/dem_gdal.h"
#include "tests/fuzz/try_terrain.h"

namespace game::test {
namespace {

Outcome<void> try_dem(const std::filesystem::path& file) {
    return check_terrain(terrains::read_dem(file, kTriedSquares));
}

}  // namespace

const TriedReader kTriedDem{"dem", "x.asc", try_dem};

}  // namespace game::test
