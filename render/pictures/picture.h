#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include <tl/expected.hpp>

namespace render {

// 8-bit sRGB, row-major, top row first.
struct Picture {
    int width = 0, height = 0;
    std::vector<std::uint8_t> pixels;  // width × height × channels
    int channels = 3;                  // 3, or 1 for grey
};

// How a PNG is compressed. The pixels are always the same.
struct PngCompression {
    int level = 6;                     // of zlib, 0 to 9
    const char* strategy = "default";  // of zlib: default, filtered, huffman, rle or fixed
    int filters = 0xf8;  // what a row may be coded by, as in png_set_filter(); the default is all
};
// For frames of a run: each row as differences from the average of its neighbours, and no search for
// repetitions, which terrain hardly has. Takes half the time of the next one; files are up to an eighth larger.
inline constexpr PngCompression kFramePngCompression{1, "huffman", 0x40};
// For single images: fast, and repetitions make charts and other plain images small.
inline constexpr PngCompression kFastPngCompression{1};
// For images that are written once and kept in the repository: takes half a second to a second.
inline constexpr PngCompression kSmallestPngCompression{9};

// Texts in a PNG: keyword, 1 to 79 letters of ASCII, and its text, UTF-8. The PNG specification gives "Title", "Software"
// and some others a meaning.
using PngTexts = std::vector<std::pair<std::string, std::string>>;

// Writes a PNG atomically (files/whole_file.h). An error is one sentence that names the file.
tl::expected<void, std::string> write_png(const Picture& picture, const std::filesystem::path& path,
                                          const PngCompression& compression = kFastPngCompression,
                                          const PngTexts& texts = {});

}  // namespace render
