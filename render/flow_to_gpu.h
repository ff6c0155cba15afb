#pragma once

#include <vector>

#include "render/gl_handle.h"
#include "sim/front/texture_layers.h"

namespace render {

// A flow's coordinates as buffers, at the slots that flow.vert reads.
class FlowToGpu {
  public:
    void upload(const sim::front::TextureLayers& layers);
    void bind() const;

  private:
    Buffer offsets_, mixes_, beside_, gradients_;
    std::size_t vertices_ = 0, gradients_fit_ = 0;
    std::vector<int> place_beside_;  // of each vertex
};

}  // namespace render
