#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include <tl/expected.hpp>

#include "render/picture.h"

// Pictures as PNG. OpenImageIO comes with over two hundred libraries, so it is linked to a module of its own,
// which is loaded when one of these is first called. The real functions are in png.cpp, and png_door.cpp
// calls them for everybody else.
namespace render {

// The bytes of a PNG file. Errors: OpenImageIO's words.
tl::expected<std::vector<unsigned char>, std::string> encode_png(const Picture& picture, int compression);

// 8 bits for each channel, lowest row first, as GL counts them.
struct Texels {
    int width = 0, height = 0, channels = 0;
    std::vector<std::uint8_t> values;

    std::size_t size() const { return static_cast<std::size_t>(width) * static_cast<std::size_t>(height); }
};

// Reads a PNG of so many channels, each of 8 bits, up to 4096 texels along an edge. Errors: one sentence that
// names the file.
tl::expected<Texels, std::string> read_png(const std::filesystem::path& path, int channels);

struct PngDoor {
    decltype(&render::encode_png) encode_png;
    decltype(&render::read_png) read_png;
};

}  // namespace render
