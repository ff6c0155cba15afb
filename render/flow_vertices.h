#pragma once

#include <cstddef>
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

// Describes all vertices of a flow in `vertices`, which has one for each vertex of its mesh.
//
// The stretch of a vertex is the root mean square over its neighbours of how far offsets differ per metre,
// weighted by the mix of the sheets. Neighbours across a front and neighbours without a texture do not count.
// A vertex where nothing ever moved has no texture of its own; it counts as fully stretched, so that debris
// that lies still is drawn there.
void describe(const sim::front::FlowView& flow, std::vector<FlowVertex>& vertices);

// Share of the advected sheets in the texture that is drawn at a stretch, 0 to 1. A sheet that lies still takes
// the rest. As in flow.frag.
float kept_share(float stretch);

}  // namespace render
