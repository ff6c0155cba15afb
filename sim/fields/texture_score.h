#pragma once

#include "sim/fields/test_flows.h"
#include "sim/front/texture_layers.h"

namespace sim::fields {

// What a flow does to a texture that it carries along, renewed every `reset_s`.
enum class Cutting {
    kNone,      // advection alone, as if there were no fronts
    kToLetter,  // cut along fronts; a vertex that one has passed keeps its coordinates
    kReseeded   // and takes up those of its new side
};

struct TextureTrial {
    double seconds = 16, unscored = 2;  // how long, and how much of its beginning does not count
    double steps_per_second = 60;
    double reset_s = 2;
    bool smooth_alone = false;  // of the flow only what is smooth, to compare with, near the same fronts
    bool frozen = false;        // coordinates stay where they are: what must be seen as standing still
};

struct TextureScore {
    // Greatest over least stretch of the drawn coordinates, ≥ 1: 95 % of the area within two cells of a front
    // has less, over all steps. The share of all area where it is above 2.
    double stretch_p95 = 1, stretched = 0;
    // How far coordinates are from travelling with the flow: root mean square of ∂c/∂t + v·∇c over that of v;
    // more than two rings away from every cut edge, and nearer. Steps of renewal and vertices that flip do
    // not count.
    double slip = 0, slip_near = 0;
    // From where particles that travel with the flow have their coordinates at the end of a period to where
    // they had them at its beginning, in cells: 95 % have less. Of those to which no front comes nearer than
    // half a cell.
    double drift_p95 = 0;
};

// On a heightfield over the unit square, by a tracker with this rule and source.
TextureScore score_texture(const front::Mesh& mesh, const front::Rule& rule, front::PointSource source,
                           const TestFlow& flow, Cutting cutting, const TextureTrial& trial);

}  // namespace sim::fields
