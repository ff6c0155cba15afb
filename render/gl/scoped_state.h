#pragma once

#include <array>

#include <epoxy/gl.h>

namespace render {

// Enables a capability until the end of the scope.
class Enabled {
  public:
    explicit Enabled(GLenum capability)
        : capability_(capability), was_on_(glIsEnabled(capability) == GL_TRUE) {
        glEnable(capability_);
    }
    ~Enabled() {
        if (!was_on_) glDisable(capability_);
    }
    Enabled(const Enabled&) = delete;
    Enabled& operator=(const Enabled&) = delete;

  private:
    GLenum capability_;
    bool was_on_;
};

// Saves the GL state that drawing changes, sets the state that all passes need, and restores it at the end of
// the scope.
class ScopedState {
  public:
    ScopedState();
    ~ScopedState();
    ScopedState(const ScopedState&) = delete;
    ScopedState& operator=(const ScopedState&) = delete;

  private:
    std::array<GLint, 4> viewport_{};
    GLint draw_framebuffer_ = 0, read_framebuffer_ = 0, program_ = 0, vertex_array_ = 0;
    GLint clip_origin_ = 0, clip_depth_ = 0, depth_function_ = 0;
    std::array<GLboolean, 5> switches_{};
};

}  // namespace render
