#pragma once

#include <filesystem>

#include "game/base/outcome.h"
#include "sim/front/mesh.h"

namespace game {

// Reads the triangles of a Wavefront OBJ file, from above: x and y count, z does not. Vertices keep their
// order and are counted from 0; whatever is neither vertex nor face is passed over. Errors: status 2, file,
// line and fact: a face that is no triangle, a number that is none, a triangle without area, an edge of three
// triangles, …
Outcome<sim::front::Mesh> read_obj(const std::filesystem::path& path);

}  // namespace game
