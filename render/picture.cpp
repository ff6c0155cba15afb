#include "render/picture.h"

#include <system_error>

#include <OpenImageIO/imageio.h>
#include <fmt/format.h>

#include "sim/check.h"

namespace render {
namespace {

// Of 0 to 9. Frames are written while the world runs on: 1 is three times as fast as the default for a
// quarter more bytes.
constexpr int kPngCompression = 1;

// Errors name `path`; the picture goes to `beside`.
tl::expected<void, std::string> write_beside(const Picture& picture, const std::filesystem::path& path,
                                             const std::filesystem::path& beside) {
    const auto failed = [&](const std::string& fact) {
        return tl::unexpected(fmt::format("{}: cannot be written: {}", path.string(), fact));
    };
    auto output = OIIO::ImageOutput::create("png");
    if (!output) return failed(OIIO::geterror());
    OIIO::ImageSpec spec(picture.width, picture.height, 3, OIIO::TypeDesc::UINT8);
    spec.attribute("oiio:ColorSpace", "sRGB");
    spec.attribute("png:compressionLevel", kPngCompression);
    if (!output->open(beside.string(), spec)) return failed(output->geterror());
    if (!output->write_image(OIIO::TypeDesc::UINT8, picture.pixels.data())) return failed(output->geterror());
    if (!output->close()) return failed(output->geterror());
    return {};
}

}  // namespace

tl::expected<void, std::string> write_png(const Picture& picture, const std::filesystem::path& path) {
    CHECK(picture.width > 0 && picture.height > 0);
    CHECK(picture.pixels.size() ==
          3ull * static_cast<unsigned>(picture.width) * static_cast<unsigned>(picture.height));
    std::filesystem::path beside = path;
    beside += ".part";
    std::error_code error;
    if (auto written = write_beside(picture, path, beside); !written) {
        std::filesystem::remove(beside, error);
        return written;
    }
    std::filesystem::rename(beside, path, error);
    if (error)
        return tl::unexpected(fmt::format("{}: cannot be written: {}", path.string(), error.message()));
    return {};
}

}  // namespace render
