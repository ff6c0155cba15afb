#pragma once

#include "sim/front/texture_layers.h"
#include "sim/front/tracker.h"

namespace sim::front {

// What is seen of a flow beside its fields: where it tears, and how textures lie on either side.
class FlowView {
  public:
    // The mesh must outlive it.
    FlowView(const Mesh& mesh, const Rule& rule, Source source, const LayerRule& layers)
        : tracker_(mesh, rule, source), layers_(mesh, layers) {}

    // To the flow as it is `dt` seconds later, > 0.
    void advance(const Flow& flow, double dt, Workers& workers) {
        tracker_.advance(flow, dt, workers);
        layers_.advance(tracker_, flow.velocity, dt, workers);
    }

    const Mesh& mesh() const { return tracker_.mesh(); }
    const Tracker& tracker() const { return tracker_; }
    const TextureLayers& layers() const { return layers_; }

  private:
    Tracker tracker_;
    TextureLayers layers_;
};

}  // namespace sim::front
