#pragma once

#include <cstdint>

#include "game/controls/screen.h"
#include "game/controls/tier.h"

namespace game {

// The size of an image that is drawn for a screen, and stretched over it if it is smaller.
struct ImageSize {
    int width = 0, height = 0;  // pixels
    bool fine = false;          // two by two samples per pixel
    bool moving =
        false;  // the ground is shaded for every second sample along x and y, render::Quality::kMoving
    bool operator==(const ImageSize&) const = default;
};

// The most that can be drawn.
struct ImageBounds {
    int longest_side = 16384;               // samples along one side
    std::uint64_t most_bytes = UINT64_MAX;  // of the buffers of an image
};

// Memory of the buffers of an image, bytes.
std::uint64_t bytes_of(const ImageSize& image);

// The least scale of moving images for a screen: that of the tier, but 640 × 360 pixels at least if the screen has as many,
// however slow the machine is, and 1280 × 720 while the camera stands still, when little is drawn anew. 0 to 1.
double least_scale(Tier tier, const ScreenSize& screen, bool camera_moves);

// The image for a screen at `scale`, drawn pixels per screen pixel along each axis. Within the bounds: if
// there is no room for two by two samples per pixel it has one, and then fewer pixels. At least 1 × 1.
ImageSize image_for(const ScreenSize& screen, double scale, bool fine, const ImageBounds& bounds);

}  // namespace game
