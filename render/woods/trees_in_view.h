#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "render/view/flow_so_far.h"
#include "render/view/frame_block.h"
#include "render/view/on_screen.h"
#include "render/woods/tree_light.h"
#include "render/woods/woods.h"
#include "sim/world/state.h"

namespace render {

// How far a flow has laid a tree of the grid until now: 0 upright, 1 in the deposit; 0 outside the grid. `flow` does not
// count where the world's state knows.
float lying(const Tree& tree, const FlowSoFar& flow);

// The share of the most snow that a tree carries: 0 where none lies near it, and the sun takes half from one on a south slope.
float snow_kept(const Tree& tree);

// A tree, or a group of some, as the GPU draws it: an element of SLOT_TREES, as in tree.glsl.
struct DrawnTree {
    glm::vec4 foot;    // m; height, m
    glm::vec4 axis;    // unit vector from foot to top; its own number, 0 to 1
    glm::vec4 look;    // sunlit 0 to 1; 0; share of the lower material there; half its width, m
    glm::vec4 shadow;  // m, where the shadow of its top meets the ground; strength of the shadow, 0 to 1
    glm::vec4
        kind;  // TreeKind; number of tops; how closed the wood is around it, 0 to 1; share of snow that branches keep
    bool operator==(const DrawnTree&) const = default;
};

// The trees of one frame. A frame depends on this frame's arguments only, so that it is the same after
// seeking.
class TreesInView {
  public:
    void reserve(std::size_t trees);
    // Finds the trees that a camera sees, as they stood at tick 0.
    void find(const LitTrees& of, const FrameBlock& frame, const OnScreen& screen);
    // The same for the same camera, if only the trees of some tiles differ. The others stay as settle() left them.
    void find_again(const LitTrees& of, std::span<const ChangedTile> changed, const FrameBlock& frame,
                    const OnScreen& screen);
    // What it found of the changed tiles: the trees that were drawn before, and the numbers of those that are in drawn().
    std::span<const DrawnTree> gone() const { return gone_; }
    std::span<const std::size_t> grown() const { return grown_; }
    // Moves them to where they are now: onto sculpted ground, and one that a flow has met leans or lies, with its top
    // downhill, on the ground now. `trees`: those of find(). `carried_off`: those that a flow broke are not where they grew.
    void settle(std::span<const Tree> trees, const sim::View& world, const FlowSoFar& flow,
                bool carried_off = false);

    // The samples that one of them and its shadow may cover.
    static Rectangle seen(const DrawnTree& tree, const OnScreen& screen);

    // From near to far.
    std::span<const DrawnTree> drawn() const { return drawn_; }
    std::size_t with_shadow() const { return with_shadow_; }  // trees up to the last one with a shadow

    // One that settle() moved, and what it was.
    struct Moved {
        std::size_t number;  // in drawn()
        DrawnTree before;
    };
    std::span<const Moved> moved() const { return moved_; }

  private:
    struct Upright {
        DrawnTree drawn;
        std::uint32_t tree;  // in LitTrees::trees
        float distance;      // of its foot, m
    };

    std::vector<Upright> upright_;
    std::vector<DrawnTree> drawn_;           // upright_, settled
    std::vector<const DrawnTree*> settled_;  // by tree, while they are found again
    std::vector<DrawnTree> drawn_before_, gone_;
    std::vector<std::size_t> grown_;
    std::vector<Moved> moved_;
    std::size_t with_shadow_ = 0;
};

}  // namespace render
