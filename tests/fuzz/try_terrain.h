#pragma once

#include <string>

#include <tl/expected.hpp>

#include "terrains/terrain.h"
#include "tests/fuzz/try_reader.h"

namespace game::test {

// Checks a terrain that was resampled to kTriedSquares.
inline Outcome<void> check_terrain(const tl::expected<terrains::Terrain, std::string>& terrain) {
    if (!terrain) return unusable(terrain.error());
    if (terrain->grid.nx > kTriedSquares + 1 || terrain->grid.ny > kTriedSquares + 1)
        return broken("more squares than wanted");
    if (terrain->surface.size() != terrain->grid.size()) return broken("a field of another size");
    return check_numbers(terrain->surface, -1e5f, 1e5f, "a height");
}

}  // namespace game::test
