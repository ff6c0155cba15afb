#pragma once

#include "render/mountain/surroundings.h"
#include "tests/render/world.h"

namespace render::test {

// As if the world were at tick 0.
Surroundings mountains_around(const World& world);

// A valley of `columns` × `rows` vertices, 5 m apart.
World make_strip(int columns, int rows);

}  // namespace render::test
