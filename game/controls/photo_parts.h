#pragma once

#include <optional>
#include <utility>

#include "game/controls/image_size.h"
#include "render/frame/frame_input.h"
#include "render/pictures/picture.h"

namespace game {

// A photo that is larger than the window, drawn in equal parts so that the buffers of an image stay as small as those of
// the window. Each part is drawn with a rim that its neighbours have too, and that is cut off.
//
//     ┌───────────┐   part 1 with its rim
//     │  ┌────┬───┼───────┐   part 2
//     │  │    │   │       │
class PhotoParts {
  public:
    // The least rim in which what differs at the border of a frame has room, px.
    static int rim_of(const std::optional<render::Lens>& lens, int height);
    // The fewest parts along an edge, and at least `times`, of which each fits into the bounds with two by two samples per
    // pixel. `rim`: px, a multiple of render::kPartOverlap. Nothing: even small ones do not fit.
    static std::optional<PhotoParts> plan(const ScreenSize& screen, int times, int rim,
                                          const ImageBounds& bounds);

    int width() const { return width_; }  // of the photo, px
    int height() const { return height_; }
    int parts() const { return across_ * up_; }
    ImageSize frame() const { return {inner_width_ + 2 * rim_, inner_height_ + 2 * rim_, true}; }
    // Where the frame of a part begins in the photo, counted from the lowest row.
    render::WholeImage place(int part) const;
    // Copies what a part shows, but for its rim, into the photo.
    void put(int part, const render::Picture& frame, render::Picture& photo) const;

  private:
    int width_ = 0, height_ = 0, across_ = 1, up_ = 1, inner_width_ = 0, inner_height_ = 0, rim_ = 0;
};

}  // namespace game
