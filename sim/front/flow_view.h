#pragma once

#include <span>

#include "sim/front/texture_layers.h"
#include "sim/front/tracker.h"

namespace sim::front {

// A view of a flow: its discontinuity fronts, and the textures on either side.
class FlowView {
  public:
    // The mesh must outlive the view.
    FlowView(const Mesh& mesh, const Rule& rule, PointSource source, const LayerRule& layers)
        : tracker_(mesh, rule, source), layers_(mesh, layers) {}

    // Advances to the flow `dt` seconds later, dt > 0, in three stages.
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

    // Sets the rise of the standing layer at each vertex since before anything moved, m. The caller keeps the
    // array. Without it no deposit is known.
    void set_rise(std::span<const float> rise) { rise_ = rise; }
    // Thickness at a vertex of the deposit that still has the texture with which it arrived, m, ≥ 0. It is 0
    // where nothing ever moved, even if material is added there.
    float deposit(int vertex) const {
        return !rise_.empty() && rise_[vertex] > 0 && layers_.has_moved(vertex) ? rise_[vertex] : 0;
    }

  private:
    Tracker tracker_;
    TextureLayers layers_;
    std::span<const float> rise_;
};

}  // namespace sim::front
