#pragma once

#include <vector>

#include "render/gl_handle.h"
#include "sim/front/flow_view.h"

namespace render {

// A flow's coordinates as buffers, at the slots that flow.vert reads.
class FlowToGpu {
  public:
    void upload(const sim::front::FlowView& flow);
    void bind() const;

  private:
    Buffer offsets_, mixes_, vertex_buffer_, gradients_;
    std::size_t vertices_ = 0, gradients_fit_ = 0;
    struct OfVertex {
        int beside;     // its place among those beside a front, −1: it is not
        float deposit;  // m
        int shows;      // whose texture it shows: its own; where nothing moved, that of what lies beside it
    };
    std::vector<OfVertex> of_vertex_;
};

}  // namespace render
