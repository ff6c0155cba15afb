#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "game/live/live_world.h"
#include "render/buildings/structure_mesh.h"
#include "render/flow/flow_mesh.h"
#include "render/mountain/bare_ground.h"
#include "render/woods/followed_woods.h"

namespace game {

// What a page draws of a world besides its layers, as the program draws it.
class LivePicture {
  public:
    // The ground without buildings, which are drawn by their triangles. Valid until the next call.
    const sim::Field<float>& ground(const LiveWorld& world);

    // The triangles that show what flows and what has come to rest, with the textures that it carries, cut along its fronts;
    // null before a person takes over, and in a world without such a texture.
    const render::FlowMesh* flow(const LiveWorld& world);

    // Two bytes per vertex of a world with two materials (render::drawn_mixture()); else none.
    const std::vector<std::uint8_t>& mixture(const LiveWorld& world);
    // Finds the trees that people have planted beyond the forest of tick 0, if the things have changed since the last call;
    // true then. Nothing hides the light from them, because a page has no ground for that.
    bool plant(const LiveWorld& world);
    struct Planted {
        glm::vec3 foot;  // m
        float height, chance, snow, closed, kind, keeps,
            lies;  // as render::Tree; render::snow_kept(); 0 or 1
    };
    const std::vector<Planted>& planted() const { return planted_; }  // tile by tile
    const std::vector<std::uint32_t>& planted_counts() const { return planted_counts_; }

    // What has become of the forest at each vertex: 0 there is none, 1 a stem stands, 2 all lie. None if nothing was ever
    // built or planted.
    const std::vector<std::uint8_t>& stands(const LiveWorld& world);

    // Depth of the standing layer at tick 0, m, and share of the lower material at its surface, per vertex; none in a model.
    std::vector<glm::vec2>& cover() { return cover_; }
    // Makes the triangles of what people have built, if it has changed since the last call; true then.
    bool build(const LiveWorld& world, glm::vec3 sun);
    const std::vector<render::StructureVertex>& faces() const { return faces_; }
    const std::vector<render::RopeVertex>& ropes() const { return mesh_.ropes; }
    const std::vector<render::StructureShadowVertex>& shadows() const { return mesh_.shadows; }

  private:
    render::BareGround bare_;
    render::FlowMesh flow_;
    std::vector<std::uint8_t> mixture_, stands_;
    render::FollowedWoods followed_;
    std::optional<sim::Things> beyond_;  // with the forest that was planted
    std::int64_t things_changed_ = -1;
    std::vector<Planted> planted_;
    std::vector<std::uint32_t> planted_counts_;
    std::vector<glm::vec2> cover_;
    std::optional<render::Structures> built_;
    render::StructureMesh mesh_;
    std::vector<render::StructureVertex> faces_;  // those that are seen from near
};

}  // namespace game
