#pragma once

#include <vector>

#include "render/gl_handle.h"
#include "sim/front/flow_view.h"

namespace render {

// Uploads a flow's texture coordinates as buffers, to the slots that flow.vert reads.
class FlowToGpu {
  public:
    void upload(const sim::front::FlowView& flow);
    void bind() const;

  private:
    Buffer offsets_, mixes_, vertex_buffer_, gradients_;
    std::size_t vertices_ = 0, gradients_fit_ = 0;
    struct OfVertex {
        int beside;     // its index among the vertices beside a front, −1: not beside one
        float deposit;  // m
        int shows;      // the vertex whose texture shows: itself, or a neighbour in the deposit
    };
    std::vector<OfVertex> of_vertex_;
};

}  // namespace render
