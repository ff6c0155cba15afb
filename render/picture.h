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

// Compression level for frames written while the simulation runs, on the PNG scale 0 to 9. Level 1 is three
// times as fast as the default and makes files a quarter larger.
inline constexpr int kFastPngCompression = 1;
inline constexpr int kSmallestPngCompression = 9;

// Writes a PNG atomically (files/whole_file.h). An error is one sentence that names the file.
tl::expected<void, std::string> write_png(const Picture& picture, const std::filesystem::path& path,
                                          int compression = kFastPngCompression);

}  // namespace render
