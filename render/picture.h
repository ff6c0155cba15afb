#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include <tl/expected.hpp>

namespace render {

// 8-bit sRGB, row-major, top row first.
struct Picture {
    int width = 0, height = 0;
    std::vector<std::uint8_t> pixels;  // width × height × channels
    int channels = 3;                  // 3, or 1 for grey
};

// Of 0 to 9. Frames are written while the world runs on: 1 is three times as fast as the default for a
// quarter more bytes.
inline constexpr int kFastPngCompression = 1;
inline constexpr int kSmallestPngCompression = 9;

// Writes a PNG as a whole file (files/whole_file.h). Errors: one sentence that names the file.
tl::expected<void, std::string> write_png(const Picture& picture, const std::filesystem::path& path,
                                          int compression = kFastPngCompression);

}  // namespace render
