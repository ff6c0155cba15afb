#pragma once

#include <filesystem>

#include "game/base/outcome.h"
#include "sim/front/mesh.h"

namespace game {

// Reads the triangles of a Wavefront OBJ file as seen from above: x and y are used, z is not. Vertices keep
// their order and are counted from 0. Lines other than vertices and faces are skipped. Errors: status 2,
// file, line and fact, such as a face that is not a triangle, a malformed number, a triangle with no area, or
// an edge with three triangles.
Outcome<sim::front::Mesh> read_obj(const std::filesystem::path& path);

// "a triangle with no area …"
const char* fact_of(sim::front::MeshFault::Kind kind);

}  // namespace game
