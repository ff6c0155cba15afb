#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>

#include <tl/expected.hpp>

#include "render/gl_handle.h"
#include "sim/core/grid.h"

namespace render {

// Computes the draw data from the fields. Reads the fields and SLOT_FIRST_DEPTH. Writes SLOT_RELIEF,
// SLOT_LAYERS and SLOT_MEASURE for every frame, SLOT_OPENNESS once per terrain.
class SurfacePass {
  public:
    static tl::expected<SurfacePass, std::string> create(const std::filesystem::path& shaders);

    void resize(const sim::Grid& grid);
    void survey_terrain() const;  // openness; the fields must be bound
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
