#pragma once

#include <span>

#include "render/base/rectangle.h"
#include "render/gl/gl_handle.h"
#include "render/pictures/picture.h"

namespace render {

// The buffers of a frame: depth and linear light, `samples` × `samples` per pixel, then 8-bit sRGB. They keep what was
// drawn, so that a frame may draw only some parts of them anew. They are recreated only when size or samples change.
//
//     depth ──▶ depth of the ground alone
//     scene: what stands there, lit ──▶ air: powder over it, if there is any ──▶ tone ──▶ picture ──▶ its edges smoothed
class Target {
  public:
    using Parts = std::span<const Rectangle>;  // of the frame, samples

    // Call before every frame. Pixels, > 0; samples along the edge of a pixel, 1 or 2. Returns true if all that was
    // drawn is lost.
    bool resize(int width, int height, int samples);

    int width() const { return width_; }
    int height() const { return height_; }
    int samples() const { return samples_; }
    int samples_across() const { return width_ * samples_; }
    int samples_up() const { return height_ * samples_; }
    Rectangle all() const { return {0, 0, samples_across(), samples_up()}; }

    void begin_scene(Parts parts) const;  // clears depth; draw depth and linear colour
    // Attaches the depth drawn so far to another framebuffer; its size in samples comes with it.
    void lend_depth(GLuint framebuffer) const;
    void begin_shading() const;  // binds depth at SLOT_SCENE_DEPTH for reading; do not write it
    // Binds colour and depth of the scene for reading by another target.
    void bind_scene(GLuint colour, GLuint depth) const;
    void bind_depth(GLuint slot) const;  // the same, depth alone
    // Keeps the depth drawn so far as that of the ground, and binds it at SLOT_SCENE_DEPTH.
    void keep_ground(Parts parts) const;
    void begin_sky() const;  // draw the sky at a quarter of the resolution; there is no depth
    void begin_backdrop()
        const;  // binds that sky at SLOT_SKY; draw linear colour, with the depth of the scene
    // Copies the scene, to be drawn over by what floats in the air. Binds depth at SLOT_SCENE_DEPTH.
    void begin_air(Parts parts);
    // Averages the samples, and returns the linear colour of every pixel. `in_air`: of the scene with the air.
    GLuint average(Parts parts, bool in_air) const;
    // Binds linear colours at SLOT_COLOUR; draw the 8-bit image.
    void begin_picture(GLuint colour) const;
    // Binds that image, not decoded, at SLOT_PICTURE, copies it and clears the stencil; draw on the copy. For one
    // sample per pixel.
    void begin_edges(Parts parts) const;

    Picture read_back() const;
    // Stretches the image over a framebuffer (0 is the window) of the given size in pixels.
    void copy_to(GLuint framebuffer, int width, int height) const;

  private:
    int width_ = 0, height_ = 0, samples_ = 1;
    Texture depth_, ground_depth_, scene_colour_, air_colour_, averaged_colour_, sky_colour_, stepped_,
        stepped_codes_, picture_, edge_marks_;
    Framebuffer scene_, air_, sky_, averaged_, stepped_output_, output_;
};

}  // namespace render
