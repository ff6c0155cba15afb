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

    // To the flow as it is `dt` seconds later, > 0; in three stages.
    void advance(const Flow& flow, double dt, Workers& workers) {
        track(flow, dt, workers);
        carry(flow, dt, workers);
        settle(dt, workers);
    }
    void track(const Flow& flow, double dt, Workers& workers) { tracker_.advance(flow, dt, workers); }
    void carry(const Flow& flow, double dt, Workers& workers) {
        layers_.carry(tracker_, flow.velocity, dt, workers);
    }
    void settle(double dt, Workers& workers) { layers_.settle(tracker_, dt, workers); }

    const Mesh& mesh() const { return tracker_.mesh(); }
    const Tracker& tracker() const { return tracker_; }
    const TextureLayers& layers() const { return layers_; }
    TextureLayers& layers() { return layers_; }

  private:
    Tracker tracker_;
    TextureLayers layers_;
};

}  // namespace sim::front
