#include "render/gl/kept_image.h"

namespace render {

KeptImage::KeptImage(int width, int height)
    : width_(width),
      height_(height),
      colour_(make_texture(GL_RGBA8, width, height, GL_NEAREST)),
      framebuffer_(make_framebuffer()) {
    glNamedFramebufferTexture(framebuffer_.name(), GL_COLOR_ATTACHMENT0, colour_.name(), 0);
}

void KeptImage::show_on(GLuint framebuffer, int width, int height) const {
    const bool fits = width == width_ && height == height_;
    glBlitNamedFramebuffer(framebuffer_.name(), framebuffer, 0, 0, width_, height_, 0, 0, width, height,
                           GL_COLOR_BUFFER_BIT, fits ? GL_NEAREST : GL_LINEAR);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    glViewport(0, 0, width, height);
}

}  // namespace render
