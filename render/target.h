#pragma once

#include "render/gl_handle.h"
#include "render/picture.h"

namespace render {

// The buffers of a frame: depth and linear light, `samples` × `samples` per pixel, then 8-bit sRGB. They are
// recreated only when one of these changes.
class Target {
  public:
    // Call before every frame. Pixels, > 0; samples along the edge of a pixel, 1 or 2.
    void resize(int width, int height, int samples);

    void begin_scene() const;  // clears depth; draw depth and linear colour
    // Attaches the depth drawn so far to another framebuffer; its size in samples comes with it.
    void lend_depth(GLuint framebuffer) const;
    int samples_across() const { return width_ * samples_; }
    int samples_up() const { return height_ * samples_; }
    void begin_shading() const;  // binds depth at SLOT_SCENE_DEPTH for reading; do not write it
    void begin_sky() const;      // draw the sky at a quarter of the resolution; there is no depth
    void begin_backdrop()
        const;  // binds that sky at SLOT_SKY; draw linear colour, with the depth of the scene
    void begin_picture() const;  // averages the samples and binds them at SLOT_COLOUR; draw the 8-bit image
    // Binds that image, not decoded, at SLOT_PICTURE, copies it and clears the stencil; draw on the copy.
    void begin_edges() const;

    Picture read_back() const;
    // Stretches the image over a framebuffer (0 is the window) of the given size in pixels.
    void copy_to(GLuint framebuffer, int width, int height) const;

  private:
    int width_ = 0, height_ = 0, samples_ = 1;
    Texture depth_, samples_colour_, colour_, sky_colour_, stepped_, stepped_codes_, picture_, edge_marks_;
    Framebuffer scene_, sky_, averaged_, stepped_output_, output_;
};

}  // namespace render
