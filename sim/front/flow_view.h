#pragma once

#include <span>

#include "sim/front/texture_layers.h"
#include "sim/front/tracker.h"

namespace sim::front {

// What is seen of a flow beside its fields: where it tears, and how textures lie on either side.
class FlowView {
  public:
    // The mesh must outlive it.
    FlowView(const Mesh& mesh, const Rule& rule, PointSource source, const LayerRule& layers)
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

    // By how much what lies at each vertex is deeper than before anything moved, m; kept by whoever sets it.
    // Without it nothing is known to have come to lie.
    void set_rise(std::span<const float> rise) { rise_ = rise; }
    // How deep a vertex lies under what has come to lie there and still has the texture with which it came,
    // m, ≥ 0. A place where nothing ever moved has none, however much is laid there.
    float deposit(int vertex) const {
        return !rise_.empty() && rise_[vertex] > 0 && layers_.has_moved(vertex) ? rise_[vertex] : 0;
    }

  private:
    Tracker tracker_;
    TextureLayers layers_;
    std::span<const float> rise_;
};

}  // namespace sim::front
