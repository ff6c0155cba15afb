#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include <tl/expected.hpp>

namespace render {

// 8-bit sRGB, 3 channels, row-major, top row first.
struct Picture {
    int width = 0, height = 0;
    std::vector<std::uint8_t> pixels;  // width × height × 3
};

// Writes a PNG beside `path` and renames it. Errors: one sentence that names the file.
tl::expected<void, std::string> write_png(const Picture& picture, const std::filesystem::path& path);

}  // namespace render
