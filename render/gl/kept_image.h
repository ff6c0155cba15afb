#pragma once

#include "render/gl/gl_handle.h"

namespace render {

// An image that is kept to be shown again, while what drew it draws something else.
class KeptImage {
  public:
    KeptImage(int width, int height);  // px; its pixels are undefined

    GLuint framebuffer() const { return framebuffer_.name(); }  // to draw it into
    // Stretches it over a framebuffer (0 is the window's) of this size in pixels, which stays bound for what is drawn on top.
    void show_on(GLuint framebuffer, int width, int height) const;

  private:
    int width_, height_;
    Texture colour_;
    Framebuffer framebuffer_;
};

}  // namespace render
