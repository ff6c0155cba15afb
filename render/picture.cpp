#include "render/picture.h"

#include <system_error>

#include <OpenImageIO/imageio.h>
#include <fmt/format.h>

#include "sim/check.h"

namespace render {
namespace {

// Errors name `path`; the picture goes to `beside`.
tl::expected<void, std::string> write_beside(const Picture& picture, const std::filesystem::path& path,
                                             const std::filesystem::path& beside, int compression) {
    const auto failed = [&](const std::string& fact) {
        return tl::unexpected(fmt::format("{}: cannot be written: {}", path.string(), fact));
    };
    auto output = OIIO::ImageOutput::create("png");
    if (!output) return failed(OIIO::geterror());
    OIIO::ImageSpec spec(picture.width, picture.height, picture.channels, OIIO::TypeDesc::UINT8);
    spec.attribute("oiio:ColorSpace", "sRGB");
    spec.attribute("png:compressionLevel", compression);
    if (!output->open(beside.string(), spec)) return failed(output->geterror());
    if (!output->write_image(OIIO::TypeDesc::UINT8, picture.pixels.data())) return failed(output->geterror());
    if (!output->close()) return failed(output->geterror());
    return {};
}

}  // namespace

tl::expected<void, std::string> write_png(const Picture& picture, const std::filesystem::path& path,
                                          int compression) {
    CHECK(picture.width > 0 && picture.height > 0);
    CHECK(picture.channels == 1 || picture.channels == 3);
    CHECK(picture.pixels.size() == 1ull * static_cast<unsigned>(picture.channels) *
                                       static_cast<unsigned>(picture.width) *
                                       static_cast<unsigned>(picture.height));
    std::filesystem::path beside = path;
    beside += ".part";
    std::error_code error;
    if (auto written = write_beside(picture, path, beside, compression); !written) {
        std::filesystem::remove(beside, error);
        return written;
    }
    std::filesystem::rename(beside, path, error);
    if (error)
        return tl::unexpected(fmt::format("{}: cannot be written: {}", path.string(), error.message()));
    return {};
}

}  // namespace render
