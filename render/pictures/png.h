#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include <tl/expected.hpp>

#include "render/pictures/picture.h"

// Reads and writes PNG images, and reads JPEG ones. OpenImageIO depends on over two hundred libraries, so a separate module links
// it and is loaded on the first call. The real functions are in png.cpp; png_door.cpp calls them for all
// others.
namespace render {

// Encodes an image as the bytes of a PNG file. Errors are OpenImageIO's messages.
tl::expected<std::vector<unsigned char>, std::string> encode_png(const Picture& picture,
                                                                 const PngCompression& compression,
                                                                 const PngTexts& texts);

// Pixels with 8 bits per channel, lowest row first, as in GL.
struct Texels {
    int width = 0, height = 0, channels = 0;
    std::vector<std::uint8_t> values;

    std::size_t size() const { return static_cast<std::size_t>(width) * static_cast<std::size_t>(height); }
};

// Reads a PNG with the given number of 8-bit channels, up to 4096 texels along an edge. An error is one
// sentence that names the file.
tl::expected<Texels, std::string> read_png(const std::filesystem::path& path, int channels);
// The same of a JPEG file.
tl::expected<Texels, std::string> read_jpeg(const std::filesystem::path& path, int channels);

struct PngDoor {
    decltype(&render::encode_png) encode_png;
    decltype(&render::read_png) read_png;
    decltype(&render::read_jpeg) read_jpeg;
};

}  // namespace render
