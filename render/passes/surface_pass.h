#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>

#include <glm/vec2.hpp>
#include <tl/expected.hpp>

#include "render/gl/gl_handle.h"
#include "sim/core/grid.h"

namespace render {

// Computes the draw data from the fields. Reads the fields and SLOT_UNDISTURBED. Writes SLOT_RELIEF,
// SLOT_LAYERS and SLOT_MEASURE for every frame, SLOT_OPENNESS where bedrock has changed.
class SurfacePass {
  public:
    static tl::expected<SurfacePass, std::string> create(const std::filesystem::path& shaders);

    void resize(const sim::Grid& grid);
    // Vertices from one to the last whose openness depends on its height.
    static int openness_reach(const sim::Grid& grid);
    // Openness of the vertices from `low` to `high` and of those in their groups; the fields must be bound.
    void survey_terrain(glm::ivec2 low, glm::ivec2 high) const;
    // Relief, layers and measure of some groups of GROUP_SQUARE² vertices: x + 65536 y. The fields must be bound.
    void run(std::span<const std::int32_t> groups) const;
    void bind() const;

  private:
    ProgramName surface_, openness_;
    sim::Grid grid_;
    Buffer groups_;
    Texture relief_texture_, layers_texture_, measure_texture_, openness_texture_;
};

}  // namespace render
