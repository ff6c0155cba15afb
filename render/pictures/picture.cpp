#include "render/pictures/picture.h"

#include <string_view>

#include <fmt/format.h>

#include "files/whole_file.h"
#include "render/pictures/png.h"
#include "sim/core/check.h"

namespace render {
tl::expected<void, std::string> write_png(const Picture& picture, const std::filesystem::path& path,
                                          const PngCompression& compression, const PngTexts& texts) {
    CHECK(picture.width > 0 && picture.height > 0);
    CHECK(picture.channels == 1 || picture.channels == 3);
    CHECK(picture.pixels.size() == 1ull * static_cast<unsigned>(picture.channels) *
                                       static_cast<unsigned>(picture.width) *
                                       static_cast<unsigned>(picture.height));
    const auto bytes = encode_png(picture, compression, texts);
    if (!bytes) return tl::unexpected(fmt::format("{}: cannot be written: {}", path.string(), bytes.error()));
    return files::write(path, {reinterpret_cast<const char*>(bytes->data()), bytes->size()});
}

}  // namespace render
