#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec2.hpp>

#include "render/gl/gl_handle.h"
#include "render/mountain/height_range.h"
#include "sim/world/state.h"

namespace render {

// Uploads the world's fields as textures, one texel per vertex without the halo, to the texture units of
// slots.glsl. Bedrock, sites, earth and first depth are sent only if they changed since the last upload.
class FieldsToGpu {
  public:
    // What changed of that which stays while a world runs.
    struct Ground {
        bool terrain = false;  // and with it perhaps the size of every texture
        // Vertices whose bedrock or earth differs, if the terrain is still the same: of sculpted ground and of
        // buildings. Valid until the next call.
        std::span<const glm::ivec2> moved;
        bool first_depth = false, undisturbed = false;  // also if it was known and is not any more
    };
    // `first_depth`, `undisturbed`: as in FrameInput; the latter is what shaders read.
    Ground upload_ground(const sim::View& world, std::span<const float> first_depth,
                         std::span<const float> undisturbed);
    // Computes the mixture as it is drawn: two shares per vertex, 0 to 255; none in a world of one material. Valid until
    // the next call.
    std::span<const std::uint8_t> find_mixture(const sim::View& world);
    // Uploads some rows of layers, velocities and that mixture, inclusive.
    void upload_layers(const sim::View& world, int first_row, int last_row) const;
    void bind() const;

    HeightRange heights() const { return heights_; }

  private:
    bool is_known(const sim::View& world) const;
    void send_moved(const sim::View& world);
    void send_earth(int first_row, int last_row) const;
    void allocate(const sim::Grid& grid);
    void remember(const sim::View& world);
    bool send_undisturbed(std::span<const float> undisturbed);

    sim::Grid grid_;
    sim::Field<float> bedrock_;  // as uploaded last
    sim::Field<sim::Site> site_;
    sim::Field<float> earth_;  // as uploaded last; nothing was, until there are things
    std::vector<glm::ivec2> moved_;
    HeightRange heights_;
    Texture bedrock_texture_, depth_texture_, rolling_texture_, velocity_x_texture_, velocity_y_texture_,
        site_texture_, mixture_texture_, undisturbed_texture_, earth_texture_;
    std::vector<float> first_depth_, undisturbed_;  // as given last
    std::vector<std::uint8_t> mixture_;
};

}  // namespace render
