#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec4.hpp>

#include "render/base/rectangle.h"
#include "render/flow/rock_mesh.h"
#include "render/flow/trunk_mesh.h"
#include "render/view/frame_block.h"
#include "render/view/on_screen.h"
#include "sim/carried/carried.h"

namespace render {

// Vertex attributes of carried.vert.
struct CarriedVertex {
    glm::vec4 at;  // m; a number of the body's own, 0 to 1, more by 1 of bark, by 2 of wood, by 3 of roots
    glm::vec4 facing;  // unit vector; share of the sky that the ground beside it leaves, 0 to 1
    glm::vec4 within;  // place in the body, m; height above the surface by its size
};

// Vertex attributes of carried_shadow.vert: a rectangle on the ground around the shadow of a body.
struct CarriedShadowVertex {
    glm::vec4 at;    // m in plan; place in the shadow, −1 to 1 along and across
    glm::vec4 foot;  // m, of the body; strength, 0 to 1
};

// The bodies of one frame. It depends on this frame's arguments only.
class CarriedInView {
  public:
    static constexpr std::size_t kMostVertices =
        120'000;  // where those of near bodies are more, the others are coarse

    // Takes memory for all that it may find.
    void reserve();
    // Finds those that a camera sees. Makes no triangle for what is smaller than a sample.
    void find(std::span<const sim::carried::Body> bodies, const FrameBlock& frame, const OnScreen& screen);
    // How far from its middle a body and its shadow reach in plan, m.
    static float reach(const sim::carried::Body& body, const FrameBlock& frame);
    bool empty() const { return bodies_.empty(); }

    // A body in view: which it is, where it and its shadow appear, and its vertices.
    struct InView {
        std::size_t body;
        Rectangle seen;
        std::uint32_t first = 0, count = 0, first_of_shadow = 0;  // six of the shadow
    };
    std::span<const InView> bodies() const { return bodies_; }
    std::span<const CarriedVertex> vertices() const { return vertices_; }
    std::span<const CarriedShadowVertex> shadows() const { return shadows_; }

  private:
    void add_boulder(const sim::carried::Body& body, float pixels);
    void add_trunk(const sim::carried::Body& body, float pixels);
    void add_shadow(const sim::carried::Body& body, glm::vec2 away, float along);

    std::array<RockMesh, kRocks> rocks_ = rock_meshes();
    std::array<std::vector<TrunkCorner>, kTrunkLevels> trunk_ = trunk_mesh();
    std::vector<InView> bodies_;
    std::vector<CarriedVertex> vertices_;
    std::vector<CarriedShadowVertex> shadows_;
};

}  // namespace render
