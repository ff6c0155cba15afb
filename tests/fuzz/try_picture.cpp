#include "tests/fuzz/try_reader.h"

#include "terrains/heightmap_image.h"
#include "tests/fuzz/try_terrain.h"

namespace game::test {
namespace {

Outcome<void> try_picture(const std::filesystem::path& file) {
    return check_terrain(terrains::read_heightmap(file, {10, 0, 1000}, kTriedSquares));
}

}  // namespace

const TriedReader kTriedPicture{"picture", "x.png", try_picture};

}  // namespace game::test
