#pragma once

#include "render/gl/gl_handle.h"
#include "render/mountain/sun_sweep.h"
#include "sim/core/grid.h"

namespace render {

// Uploads, for every vertex, the height below which the sun is hidden. Writes SLOT_SUN_CEILING.
class ShadowPass {
  public:
    void resize(const sim::Grid& grid);
    // Uploads the rows that the last run changed. Call it after each run of the sweep.
    void upload(const SunSweep& sweep);
    void bind() const;

  private:
    sim::Grid grid_;
    Texture ceiling_texture_;
    bool is_new_ = false;  // the texture
};

}  // namespace render
