#include "game/live/picture.h"

#include <algorithm>
#include <cstdint>

#include "render/mountain/drawn_mixture.h"
#include "render/woods/trees_in_view.h"

namespace game {

const sim::Field<float>& LivePicture::ground(const LiveWorld& world) {
    const sim::Field<float>* const bare = bare_.find(world.sandbox().session().view());
    return bare ? *bare : world.state().bedrock;
}

const render::FlowMesh* LivePicture::flow(const LiveWorld& world) {
    const Scenario& scenario = world.sandbox().scenario();
    const Session& session = world.sandbox().session();
    if (!session.fronts()) return nullptr;
    flow_.make(*session.fronts(), session.view(), session.undisturbed(), scenario.look);
    return &flow_;
}

const std::vector<std::uint8_t>& LivePicture::mixture(const LiveWorld& world) {
    render::drawn_mixture(world.sandbox().session().view(), mixture_);
    return mixture_;
}

const std::vector<std::uint8_t>& LivePicture::stands(const LiveWorld& world) {
    const sim::State& s = world.state();
    stands_.clear();
    if (!s.things) return stands_;
    for (int y = 0; y < s.grid.ny; ++y)
        for (int x = 0; x < s.grid.nx; ++x) {
            const sim::Stems& stems = s.things->forest(x, y);
            stands_.push_back(stems.standing > 0 ? 1 : stems.lying > 0 ? 2 : 0);
        }
    return stands_;
}

bool LivePicture::plant(const LiveWorld& world) {
    const sim::View now = world.sandbox().session().view();
    if (!now.things) {
        things_changed_ = -1;
        const bool had_any = !planted_.empty();
        planted_.clear();
        planted_counts_.clear();
        return had_any;
    }
    if (now.things->changed == things_changed_) return false;
    things_changed_ = now.things->changed;
    beyond_ = *now.things;
    for (int y = 0; y < now.grid.ny; ++y)
        for (int x = 0; x < now.grid.nx; ++x) {
            sim::Stems& stems = beyond_->forest(x, y);
            const sim::Stems first =
                world.first_forest().nx() > 0 ? world.first_forest()(x, y) : sim::Stems();
            const int all = stems.standing + stems.lying,
                      more = std::max(all - first.standing - first.lying, 0),
                      lying = all > 0 ? more * stems.lying / all : 0;
            stems.lying = static_cast<std::uint16_t>(lying);
            stems.standing = static_cast<std::uint16_t>(more - lying);
        }
    sim::View view = now;
    view.things = &*beyond_;
    followed_.follow(nullptr, nullptr, view, world.sandbox().scenario().depth, glm::vec3(0, 0, 1), false);
    planted_.clear();
    planted_counts_.clear();
    const render::LitTrees shown = followed_.trees();
    for (const render::TreeTile& tile : shown.tiles) {
        if (tile.count == 0) continue;
        planted_counts_.push_back(tile.count);
        for (const render::Tree& t : shown.trees.subspan(tile.first, tile.count))
            planted_.push_back({t.foot, t.height, t.chance, t.snow, t.closed, static_cast<float>(t.kind),
                                render::snow_kept(t), t.fate == render::TreeFate::kLies ? 1.f : 0.f});
    }
    return true;
}

bool LivePicture::build(const LiveWorld& world, glm::vec3 sun) {
    const Session& session = world.sandbox().session();
    if (built_ == session.structures()) return false;
    built_ = session.structures();
    const Scenario& scenario = world.sandbox().scenario();
    const sim::View view = sim::on_bedrock(session.view(), ground(world));
    const render::BuildingGround on_ground{view, scenario.depth, cover_, render::snowy(scenario.look)};
    mesh_ = render::structure_mesh(*built_, on_ground, sun);
    faces_.clear();
    for (const render::StructurePart& part : mesh_.parts)
        faces_.insert(faces_.end(), mesh_.faces.begin() + part.near.first,
                      mesh_.faces.begin() + part.near.first + part.near.count);
    return true;
}

}  // namespace game
