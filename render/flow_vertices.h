#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "sim/front/flow_view.h"

namespace render {

// What flow.vert needs of a vertex, besides its offsets.
struct FlowVertex {
    int beside = -1;    // its index among the vertices beside a front, −1: not beside one
    float deposit = 0;  // m
    int shows = 0;      // the vertex whose texture shows: itself, or a neighbour in the deposit
    float stretch = 0;  // how far its texture is stretched, 0: not at all
};

// Describes all vertices of a flow. The cost grows with the groups of vertices where anything ever moved.
//
// The stretch of a vertex is the root mean square over its neighbours of how far offsets differ per metre,
// weighted by the mix of the sheets. Neighbours across a front and neighbours without a texture do not count.
// A vertex where nothing ever moved has no texture of its own; it counts as fully stretched, so that debris
// that lies still is drawn there.
class FlowVertices {
  public:
    void describe(const sim::front::FlowView& flow);

    std::span<const FlowVertex> values() const { return values_; }

    // Where anything may differ from the last call: the values, offsets and mixes of these groups of
    // sim::front::TextureLayers, ascending, and the values of these vertices, in no order and some of them twice.
    std::span<const int> groups() const { return groups_; }
    std::array<std::span<const int>, 4> others() const {
        return {guests_, guests_before_, beside_, beside_before_};
    }
    // Vertices that show another's texture.
    std::span<const int> guests() const { return guests_; }

  private:
    void begin(const sim::front::FlowView& flow);
    void find_deposit(const sim::front::FlowView& flow);
    void find_beside(const sim::front::FlowView& flow);
    template <class Visit>
    void for_vertices(const Visit& visit) const;

    std::vector<FlowVertex> values_;
    std::vector<int> groups_;
    std::vector<std::uint8_t> touched_before_;
    std::vector<int> guests_, guests_before_, beside_, beside_before_;
};

// Share of the advected sheets in the texture that is drawn at a stretch, 0 to 1. A sheet that lies still takes
// the rest. As in flow.frag.
float kept_share(float stretch);

}  // namespace render
