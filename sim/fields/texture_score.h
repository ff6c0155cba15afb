#pragma once

#include "sim/fields/test_flows.h"
#include "sim/front/texture_layers.h"

namespace sim::fields {

// How fronts cut a texture that is advected with a flow and renewed every `reset_s`.
enum class Cutting {
    kNone,      // advection alone, without fronts
    kToLetter,  // cut along fronts; a vertex that one has passed keeps its coordinates
    kReseeded   // the same, but the vertex takes coordinates of its new side
};

struct TextureTrial {
    double seconds = 16, unscored = 2;  // duration, and how much of its beginning is not scored
    double steps_per_second = 60;
    double reset_s = 2;
    bool smooth_alone = false;  // only the smooth part of the flow, for comparison near the same fronts
    bool frozen = false;        // coordinates do not move; must score as standing still
};

struct TextureScore {
    // stretch_p95: 95th percentile of the ratio of greatest to least stretch, ≥ 1, over the drawn area within
    // two cells of a front and all steps. stretched: share of all area where the ratio is above 2.
    double stretch_p95 = 1, stretched = 0;
    // Deviation of the coordinates from advection: root mean square of ∂c/∂t + v·∇c divided by that of v.
    // slip: more than two rings away from every cut edge; slip_near: nearer. Steps of renewal and vertices
    // that flip are left out.
    double slip = 0, slip_near = 0;
    // 95th percentile of drift, cells: how far the coordinates of particles that travel with the flow move
    // away from them in a period. Only particles to which no front comes nearer than half a cell count.
    double drift_p95 = 0;
};

// Scores a flow on a heightfield over the unit square, with a tracker of this rule and source.
TextureScore score_texture(const front::Mesh& mesh, const front::Rule& rule, front::PointSource source,
                           const TestFlow& flow, Cutting cutting, const TextureTrial& trial);

}  // namespace sim::fields
