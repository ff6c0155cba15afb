#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include <tl/expected.hpp>

namespace terrains {

struct GreyPicture {
    int width = 0, height = 0;
    std::vector<float> brightness;  // 0 to 1, row-major, top row first
    std::string licence;            // copyright stated in the file
};

// Reads the first channel of a PNG, TIFF, PNM, OpenEXR, JPEG or BMP file in its stored type. The first bytes
// decide the format, never the name. No other format is tried, because some name further files or servers
// (playlists, session descriptions). Errors, in one sentence that names the file: those of check_input(),
// another format, damage, over 100 million pixels, in colour, half floats, a float outside 0 to 1.
tl::expected<GreyPicture, std::string> read_grey_picture(const std::filesystem::path& path);

}  // namespace terrains
