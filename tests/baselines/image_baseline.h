#pragma once

#include <filesystem>
#include <string>

#include <gtest/gtest.h>

#include "render/pictures/picture.h"

namespace baselines {

// How far a frame may be from its baseline, in steps of 0 to 255 of one channel. Another version of Mesa, or
// a GPU, rounds edges and filtered textures differently; a pass that is missing or paints another colour is
// farther off.
struct ImageTolerance {
    double mean = 0.35;  // over all channels of all pixels
    int worst = 64;      // of one channel of one pixel, where a neighbour does not have the value either
};

// A PNG of three channels, top row first; empty if it cannot be read.
render::Picture read_image(const std::filesystem::path& path);

bool are_alike(const render::Picture& a, const render::Picture& b, const ImageTolerance& tolerance = {});

// Compares a frame with tests/baselines/NAME.png. On failure the frame, the baseline and their difference are
// written to build/PRESET/tests/baselines as NAME.actual.png, NAME.expected.png and NAME.difference.png.
// With COULOIR_RENEW_BASELINES=1 the frame becomes the baseline.
testing::AssertionResult matches_baseline(const render::Picture& frame, const std::string& name,
                                          const ImageTolerance& tolerance = {});

}  // namespace baselines
