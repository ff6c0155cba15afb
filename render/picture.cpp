#include "render/picture.h"

#include <string_view>

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>
#include <fmt/format.h>

#include "files/whole_file.h"
#include "sim/check.h"

namespace render {
namespace {

// In memory: OpenImageIO does not say when the last bytes of a file could not be written.
tl::expected<std::vector<unsigned char>, std::string> encode_png(const Picture& picture, int compression) {
    auto output = OIIO::ImageOutput::create("png");
    if (!output) return tl::unexpected(OIIO::geterror());
    OIIO::ImageSpec spec(picture.width, picture.height, picture.channels, OIIO::TypeDesc::UINT8);
    spec.attribute("oiio:ColorSpace", "sRGB");
    spec.attribute("png:compressionLevel", compression);
    std::vector<unsigned char> bytes;
    OIIO::Filesystem::IOVecOutput memory(bytes);
    if (!output->set_ioproxy(&memory) || !output->open("picture.png", spec) ||
        !output->write_image(OIIO::TypeDesc::UINT8, picture.pixels.data()) || !output->close())
        return tl::unexpected(output->geterror());
    return bytes;
}

}  // namespace

tl::expected<void, std::string> write_png(const Picture& picture, const std::filesystem::path& path,
                                          int compression) {
    CHECK(picture.width > 0 && picture.height > 0);
    CHECK(picture.channels == 1 || picture.channels == 3);
    CHECK(picture.pixels.size() == 1ull * static_cast<unsigned>(picture.channels) *
                                       static_cast<unsigned>(picture.width) *
                                       static_cast<unsigned>(picture.height));
    const auto bytes = encode_png(picture, compression);
    if (!bytes) return tl::unexpected(fmt::format("{}: cannot be written: {}", path.string(), bytes.error()));
    return files::write(path, {reinterpret_cast<const char*>(bytes->data()), bytes->size()});
}

}  // namespace render
