#include "tests/fuzz/try_reader.h"

#include "terrains/release.h"

namespace game::test {
namespace {

// A slope in the Alps, for outlines in degrees.
const terrains::Terrain& slope() {
    static const terrains::Terrain made = [] {
        terrains::Terrain terrain;
        terrain.name = "slope";
        terrain.grid.nx = terrain.grid.ny = kTriedSquares + 1;
        terrain.grid.dx = 10;
        terrain.surface.assign(terrain.grid.size(), 2000);
        terrain.cover.assign(terrain.grid.size(), 0);
        terrain.has_data.assign(terrain.grid.size(), 1);
        terrain.georeference = terrains::Georeference::local({47, 11}, -80, -80);
        return terrain;
    }();
    return made;
}

Outcome<void> try_release(const std::filesystem::path& file) {
    const auto depth = terrains::read_release(file, slope());
    if (!depth) return unusable(depth.error());
    return check_numbers(*depth, 0, 200, "a release");
}

}  // namespace

const TriedReader kTriedGeojson{"geojson", "x.geojson", try_release};

}  // namespace game::test
