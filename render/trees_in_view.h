#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "render/flow_so_far.h"
#include "render/frame_block.h"
#include "render/woods.h"
#include "sim/world/state.h"

namespace render {

// The light of a tree, and where its shadow ends. Changes with the direction of the light only.
struct TreeLight {
    float sunlit;   // share of the light that ground lets through to the tree, 0 to 1
    glm::vec3 tip;  // m, where the shadow of its top meets the ground
};

// For each tree of `woods`: the light from `sun` (unit vector, z > 0).
void light_trees(const Woods& woods, const Surroundings& around, const glm::vec3& sun,
                 std::vector<TreeLight>& into);

// A tree as the GPU draws it. Vertex attributes of tree.vert and tree_shadow.vert.
struct DrawnTree {
    glm::vec4 foot;  // m; height, m
    glm::vec4 axis;  // unit vector from foot to top; its own number, 0 to 1
    glm::vec4 look;  // sunlit 0 to 1; snow around it, m; share of the lower material there; half its width, m
    glm::vec4 shadow;  // m, where the shadow of its top meets the ground; strength of the shadow, 0 to 1
};

// The trees of one frame. No GL. A frame depends on this frame's arguments only, so that it is the same after seeking.
class TreesInView {
  public:
    // Makes room for all trees of `woods`.
    void reserve(const Woods& woods);
    // `lights`: of light_trees(). A tree that a flow has met leans or lies, with its top downhill, on the ground now.
    void find(const Woods& woods, std::span<const TreeLight> lights, const sim::View& world,
              const FlowSoFar& flow, const FrameBlock& frame);

    // First far ones, of one triangle each, from near to far: at first those without a shadow. Then near ones, of more
    // triangles.
    std::span<const DrawnTree> drawn() const { return drawn_; }
    std::size_t without_shadow() const { return without_shadow_; }
    std::size_t far() const { return far_; }

  private:
    std::vector<DrawnTree> drawn_, with_shadow_, near_;
    std::vector<const TreeTile*> tiles_;
    std::size_t without_shadow_ = 0, far_ = 0;
};

}  // namespace render
