#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "game/scene/scenario.h"
#include "game/share/packed_stream.h"
#include "render/buildings/structures.h"
#include "render/mountain/land.h"
#include "render/mountain/surroundings.h"
#include "render/view/flow_so_far.h"
#include "render/view/frame_block.h"
#include "render/woods/tree_light.h"
#include "render/woods/woods.h"
#include "sim/world/state.h"

namespace game {

// What a page shows besides the layers: the mountains around, trees, light. As this program draws them.
class Scenery {
  public:
    // `first`: the world at tick 0. `scenario` must outlive this.
    Scenery(const Scenario& scenario, const sim::View& first, const render::Structures& structures,
            const render::FrameBlock& frame);

    const render::Surroundings& surroundings() const { return around_; }
    const render::FrameBlock& frame() const { return frame_; }  // that of these surroundings
    // Notes the trees that a flow has laid down by now, and what it has done to structures. `forest`: the stems at each
    // vertex, if there are any at tick 0; else none. `frame`: number of the moment.
    void see(const render::FlowSoFar& flow, std::span<const sim::Stems> forest,
             const render::Structures& structures, std::int64_t frame);

    bool has_trees() const { return !trees_.empty(); }
    void pack(PackedStream& into) const;  // what is there at tick 0
    void pack_ends(PackedStream& into, const sim::View& world,
                   std::int64_t frames) const;  // what became of it

  private:
    void find_trees(const sim::View& first);
    void pack_surroundings(PackedStream& into) const;
    void pack_land(PackedStream& into) const;
    void pack_woods(PackedStream& into) const;
    void pack_ridges(PackedStream& into) const;
    void pack_structures(PackedStream& into, const sim::View& world, std::int64_t frames) const;

    const Scenario& scenario_;
    render::Surroundings around_;
    render::Land land_;
    std::vector<render::Tree> trees_;  // at tick 0, tile by tile
    std::vector<render::TreeLight> tree_lights_;
    std::vector<std::uint32_t> tiles_;  // trees of each
    render::FrameBlock frame_;
    std::vector<float> ceilings_;
    int rays_ = 0;
    std::vector<std::int64_t> fell_;       // of each tree: the frame at which it lay; −1: it stands
    std::vector<std::uint32_t> standing_;  // trees of the grid that stand
    // Structures from a frame on.
    struct Built {
        std::int64_t from;
        render::Structures structures;
    };
    std::vector<Built> built_;
};

}  // namespace game
