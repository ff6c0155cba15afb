#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "render/gl_handle.h"
#include "render/height_range.h"
#include "sim/world/state.h"

namespace render {

// Uploads the world's fields as textures, one texel per vertex without the halo, to the texture units of
// slots.glsl. Layers and velocities are sent every time, bedrock and sites only if they changed since the
// last upload.
class FieldsToGpu {
  public:
    // Uploads what changed. Returns true if the terrain changed, and with it perhaps the size of every
    // texture. `first_depth`: as in FrameInput.
    bool upload(const sim::View& world, std::span<const float> first_depth);
    void bind() const;

    HeightRange heights() const { return heights_; }

  private:
    bool is_known(const sim::View& world) const;
    void allocate(const sim::Grid& grid);
    void remember(const sim::View& world);
    void send_mixture(const sim::View& world);
    void send_first_depth(std::span<const float> first_depth);

    sim::Grid grid_;
    sim::Field<float> bedrock_;  // as uploaded last
    sim::Field<sim::Site> site_;
    HeightRange heights_;
    Texture bedrock_texture_, depth_texture_, rolling_texture_, velocity_x_texture_, velocity_y_texture_,
        site_texture_, mixture_texture_, first_depth_texture_;
    std::vector<float> first_depth_;     // as uploaded last
    std::vector<std::uint8_t> mixture_;  // as uploaded: two shares per vertex, 0 to 255
};

}  // namespace render
