#pragma once

#include "render/gl_handle.h"
#include "render/picture.h"

namespace render {

// Where a frame is drawn: depth and linear light, `samples` × `samples` to a pixel, then 8-bit sRGB. Made
// anew when one of them changes, and only then.
class Target {
  public:
    // Before every frame. Pixels, > 0; samples along the edge of a pixel, 1 or 2.
    void resize(int width, int height, int samples);

    void begin_scene() const;  // depth is cleared; draw depth and linear colour
    // Of what was drawn into it so far, to draw on; its size in samples goes with it.
    void lend_depth(GLuint framebuffer) const;
    int samples_across() const { return width_ * samples_; }
    int samples_up() const { return height_ * samples_; }
    void begin_shading() const;  // depth can be read at SLOT_SCENE_DEPTH while it is not drawn to
    void begin_picture() const;  // samples are averaged and bound at SLOT_COLOUR; draw the 8-bit picture

    Picture read_back() const;
    // Stretches the picture over a framebuffer (0 is the window) of the given size in pixels.
    void copy_to(GLuint framebuffer, int width, int height) const;

  private:
    int width_ = 0, height_ = 0, samples_ = 1;
    Texture depth_, samples_colour_, colour_, picture_;
    Framebuffer scene_, averaged_, output_;
};

}  // namespace render
