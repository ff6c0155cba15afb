#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec4.hpp>
#include <tl/expected.hpp>

#include "render/base/rectangle.h"
#include "render/gl/gl_handle.h"

namespace render {

// Rectangles of the target, as the GPU draws them.
class Rectangles {
  public:
    // `width` and `height` of the target, samples. Grows its buffer only if there are more than ever before.
    void send(std::span<const Rectangle> rectangles, int width, int height);
    void draw() const;

  private:
    VertexArray vertex_array_;
    Buffer buffer_;
    std::size_t room_ = 0;  // rectangles that it can hold
    std::vector<glm::vec4> corners_;
};

// Runs a fragment shader over rectangles of the target, only where something was drawn. Leaves depth alone, so the
// shader may read it.
class RectanglePass {
  public:
    static tl::expected<RectanglePass, std::string> create(
        const std::filesystem::path& shaders, const std::vector<std::string_view>& fragment_files);
    // Within `parts` of the target.
    void draw_on(const Rectangles& rectangles, std::span<const Rectangle> parts) const;

  private:
    ProgramName program_;
};

}  // namespace render
