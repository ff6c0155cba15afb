#include "tests/fuzz/try_reader.h"

#include <fmt/format.h>

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
    const auto release = terrains::read_release(file, slope());
    if (!release) return unusable(release.error());
    const terrains::ReleaseVolumes& v = release->volumes;
    for (const double volume : {v.in_file, v.on_ground, v.outside, v.on_no_data, v.overlap})
        if (!(volume >= -1e-6 * v.in_file))
            return broken(fmt::format("a volume of the release is {}", volume));
    return check_numbers(release->thickness, 0, 200, "a release");
}

}  // namespace

const TriedReader kTriedGeojson{"geojson", "x.geojson", try_release};

}  // namespace game::test
