#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include <tl/expected.hpp>

namespace terrains {

struct GreyPicture {
    int width = 0, height = 0;
    std::vector<float> brightness;  // 0 to 1, row-major, top row first; NaN where it is transparent
    std::string licence;            // copyright stated in the file
};

// Reads the grey channel of a PNG, TIFF, PNM, OpenEXR, JPEG or BMP file in its stored type. Opacity, if it has a second
// channel for it, changes no brightness; where it is 0 nothing is known. The first bytes
// decide the format, never the name. No other format is tried, because some name further files or servers
// (playlists, session descriptions). Errors, in one sentence that names the file: those of check_input(),
// another format, damage, over 100 million pixels, in colour, a second channel that is no opacity, an image that is to be
// shown turned, half floats, a float outside 0 to 1, a pixel that is partly transparent in a format that stores grey
// times opacity, nothing but transparent pixels.
tl::expected<GreyPicture, std::string> read_grey_picture(const std::filesystem::path& path);

}  // namespace terrains
