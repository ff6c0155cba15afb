#pragma once

#include <span>
#include <vector>

#include "render/flow_vertices.h"
#include "render/gl_handle.h"
#include "sim/front/flow_view.h"

namespace render {

// Uploads a flow's texture coordinates as buffers, to the slots that flow.vert reads.
class FlowToGpu {
  public:
    void upload(const sim::front::FlowView& flow);
    std::span<const int> changed() const { return changed_; }
    void bind() const;

  private:
    Buffer offsets_, mixes_, vertex_buffer_, gradients_;
    std::size_t vertices_ = 0, gradients_fit_ = 0;
    std::vector<FlowVertex> of_vertex_;
    std::vector<int> changed_;
};

}  // namespace render
