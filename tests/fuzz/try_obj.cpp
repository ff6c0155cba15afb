#include "tests/fuzz/try_reader.h"

#include "game/files/mesh_file.h"

namespace game::test {
namespace {

Outcome<void> try_mesh(const std::filesystem::path& file) {
    const auto mesh = read_obj(file);
    if (!mesh) return tl::unexpected(mesh.error());
    if (mesh->triangle.empty()) return broken("no triangle");
    return check_numbers(mesh->length, 1e-6f, 1e9f, "the length of an edge");
}

}  // namespace

const TriedReader kTriedObj{"obj", "x.obj", try_mesh};

}  // namespace game::test
