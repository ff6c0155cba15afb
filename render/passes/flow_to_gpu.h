#pragma once

#include <span>

#include "render/flow/flow_changes.h"
#include "render/gl/gl_handle.h"
#include "sim/front/flow_view.h"

namespace render {

// Uploads what changed of a flow's texture coordinates, as buffers, to the slots that flow.vert reads.
class FlowToGpu {
  public:
    // The flow's mesh is a heightfield.
    void upload(const sim::front::FlowView& flow);
    void bind() const;

    // As in FlowChanges, since the upload before.
    std::span<const int> changed() const { return changes_.changed(); }
    std::span<const FlowVertex> vertices() const { return changes_.vertices(); }

  private:
    FlowChanges changes_;
    Buffer offsets_, mixes_, vertex_buffer_, gradients_;
    std::size_t vertices_ = 0, gradients_fit_ = 0;
};

}  // namespace render
