#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include <tl/expected.hpp>

#include "render/flow/carried_in_view.h"
#include "render/frame/frame_input.h"
#include "render/frame/redrawn.h"
#include "render/gl/gl_handle.h"

namespace render {

// Draws what a flow of soil carries, and its shadows on the ground.
class CarriedPass {
  public:
    static tl::expected<CarriedPass, std::string> create(const std::filesystem::path& shaders);

    // Finds the bodies of a frame and, if only the world changed, marks those that moved and those on ground that did.
    void find(const FrameInput& input, const Redraw& redraw);
    bool any() const { return !in_view_.empty(); }
    // Draws colour and depth over what is drawn, in parts of the frame.
    void draw(std::span<const Rectangle> parts);

  private:
    void make_room();
    void send();
    void mark(const CarriedInView& bodies, std::span<const std::uint8_t> changed, ScreenTiles& tiles) const;
    void find_changed(std::span<const sim::carried::Body> bodies);
    void list(const Rectangle& part);

    ProgramName program_, shadow_program_;
    VertexArray array_, shadow_array_;
    Buffer vertices_, shadow_vertices_;
    bool has_room_ = false;  // in these buffers
    CarriedInView in_view_;
    std::vector<sim::carried::Body> known_;  // of the last frame
    std::vector<std::uint8_t> changed_;      // of each body: not 0 if it is not as in the last frame
    std::vector<GLint> firsts_, shadow_firsts_;
    std::vector<GLsizei> counts_, shadow_counts_;
};

}  // namespace render
