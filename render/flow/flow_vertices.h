#pragma once

#include <span>

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
void describe(const sim::front::FlowView& flow, std::span<FlowVertex> vertices);

// The parts of it for one vertex, by which a description is kept up to date.
//
// The vertex whose texture shows at a vertex. Reads the deposits of its neighbours in `vertices`: a deposit is extended
// by one vertex, because otherwise its texture would be stretched to that of untouched ground.
int shown_at(const sim::front::FlowView& flow, std::span<const FlowVertex> vertices, int vertex);

// The stretch at a vertex: the root mean square over its neighbours of how far offsets differ per metre, weighted by the
// mix of the sheets. Neighbours across a front and neighbours without a texture do not count. Reads what the vertex and
// its neighbours show in `vertices`.
// A vertex where nothing ever moved has no texture of its own; it counts as fully stretched, so that debris that lies
// still is drawn there.
float stretch_at(const sim::front::FlowView& flow, std::span<const FlowVertex> vertices, int vertex);

// Share of the advected sheets in the texture that is drawn at a stretch, 0 to 1. A sheet that lies still takes
// the rest. As in flow.frag.
float kept_share(float stretch);

}  // namespace render
