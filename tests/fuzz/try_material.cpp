#include "tests/fuzz/try_reader.h"

#include "game/scene/material.h"
#include "sim/world/params.h"

namespace game::test {
namespace {

Outcome<void> try_material(const std::filesystem::path& file) {
    for (const auto model : {sim::Model::kBcre, sim::Model::kBcreInertial}) {
        const auto material = load_material(file.string(), model);
        if (!material) return tl::unexpected(material.error());
        if (const auto fault = sim::fault_of(material->params)) return broken(*fault);
    }
    return {};
}

}  // namespace

const TriedReader kTriedMaterial{"material", "x.toml", try_material};

}  // namespace game::test
