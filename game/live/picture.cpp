#include "game/live/picture.h"

#include "render/mountain/drawn_mixture.h"

namespace game {

const sim::Field<float>& LivePicture::ground(const LiveWorld& world) {
    const sim::Field<float>* const bare = bare_.find(world.sandbox().session().view());
    return bare ? *bare : world.state().bedrock;
}

const render::FlowMesh* LivePicture::flow(const LiveWorld& world) {
    const Scenario& scenario = world.sandbox().scenario();
    const Session& session = world.sandbox().session();
    if (!session.fronts()) return nullptr;
    flow_.make(*session.fronts(), session.view(), scenario.depth, scenario.look);
    return &flow_;
}

const std::vector<std::uint8_t>& LivePicture::mixture(const LiveWorld& world) {
    render::drawn_mixture(world.sandbox().session().view(), mixture_);
    return mixture_;
}

const std::vector<std::uint8_t>& LivePicture::stands(const LiveWorld& world) {
    const sim::State& s = world.state();
    stands_.clear();
    if (!s.things || !world.sandbox().scenario().woods_act()) return stands_;
    for (int y = 0; y < s.grid.ny; ++y)
        for (int x = 0; x < s.grid.nx; ++x) stands_.push_back(s.things->forest(x, y).standing > 0 ? 1 : 0);
    return stands_;
}

bool LivePicture::build(const LiveWorld& world, glm::vec3 sun) {
    const Session& session = world.sandbox().session();
    if (built_ == session.structures()) return false;
    built_ = session.structures();
    const Scenario& scenario = world.sandbox().scenario();
    sim::View on = session.view();
    const sim::Field<float>& bare = ground(world);
    const sim::View view{on.grid,       bare,     on.depth,        on.rolling, on.velocity_x,
                         on.velocity_y, on.site,  on.smooth_depth, on.mixture, on.things,
                         on.tiles,      on.datum, on.tick};
    const render::BuildingGround on_ground{view, scenario.depth, cover_, render::snowy(scenario.look)};
    mesh_ = render::structure_mesh(*built_, on_ground, sun);
    faces_.clear();
    for (const render::StructurePart& part : mesh_.parts)
        faces_.insert(faces_.end(), mesh_.faces.begin() + part.near.first,
                      mesh_.faces.begin() + part.near.first + part.near.count);
    return true;
}

}  // namespace game
