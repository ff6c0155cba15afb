#include "tests/fuzz/try_reader.h"

#include "terrains/dem_gdal.h"
#include "terrains/release.h"
#include "tests/fuzz/try_terrain.h"

namespace game::test {
namespace {

Outcome<void> try_dem(const std::filesystem::path& file) {
    const auto terrain = terrains::read_dem(file, kTriedSquares);
    if (auto sound = check_terrain(terrain); !sound) return sound;
    // Its numbers as depths too, unless they are too large, on the ground that they are as heights.
    const auto change = terrains::read_reference(file, *terrain);
    if (!change) return {};
    if (!(change->in_file >= 0 && change->outside >= 0)) return broken("a volume that is no number");
    return check_numbers(change->change, -200, 200, "a change of height");
}

}  // namespace

const TriedReader kTriedDem{"dem", "x.asc", try_dem};

}  // namespace game::test
