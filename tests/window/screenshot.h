#pragma once

#include <filesystem>

#include "render/pictures/picture.h"

namespace game::test {

// A part of an X server's screen kept in a file (Xvfb -fbdir, an XWD file of 24 bit). Throws
// std::runtime_error for other kinds. Pixels off the screen are black.
render::Picture read_screen(const std::filesystem::path& file, int x, int y, int width, int height);

// Share of the pixels in which two images differ by more than `least`, 0 to 1; 1 if the sizes differ.
double difference(const render::Picture& a, const render::Picture& b, int least = 8);

// The middle of an image, `part` of its width and height.
render::Picture middle(const render::Picture& picture, double part);

}  // namespace game::test
