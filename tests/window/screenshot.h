#pragma once

#include <filesystem>

#include "render/picture.h"

namespace game::test {

// A part of the screen that an X server keeps in a file (Xvfb -fbdir, an XWD file of 24 bit). Throws
// std::runtime_error for another kind. What lies off the screen is black.
render::Picture read_screen(const std::filesystem::path& file, int x, int y, int width, int height);

// Part of the pixels in which two pictures differ by more than a trace of `least`, 0 to 1; 1 where the sizes
// do.
double difference(const render::Picture& a, const render::Picture& b, int least = 8);

// The middle of a picture, `part` of its width and height.
render::Picture middle(const render::Picture& picture, double part);

}  // namespace game::test
