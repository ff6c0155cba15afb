#include "render/pictures/png.h"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>
#include <fmt/format.h>

namespace render {

// Encodes in memory, because OpenImageIO does not report a failure to write the last bytes of a file.
tl::expected<std::vector<unsigned char>, std::string> encode_png(const Picture& picture,
                                                                 const PngCompression& compression,
                                                                 const PngTexts& texts) {
    auto output = OIIO::ImageOutput::create("png");
    if (!output) return tl::unexpected(OIIO::geterror());
    OIIO::ImageSpec spec(picture.width, picture.height, picture.channels, OIIO::TypeDesc::UINT8);
    spec.attribute("oiio:ColorSpace", "sRGB");
    spec.attribute("png:compressionLevel", compression.level);
    spec.attribute("compression", compression.strategy);
    spec.attribute("png:filter", compression.filters);
    for (const auto& [keyword, text] : texts) spec.attribute(keyword, text);
    std::vector<unsigned char> bytes;
    bytes.reserve(picture.pixels.size());  // hardly a file is larger, and growing takes a twelfth of the time
    OIIO::Filesystem::IOVecOutput memory(bytes);
    if (!output->set_ioproxy(&memory) || !output->open("picture.png", spec) ||
        !output->write_image(OIIO::TypeDesc::UINT8, picture.pixels.data()) || !output->close())
        return tl::unexpected(output->geterror());
    return bytes;
}

static constexpr int kLargest = 4096;  // texels along an edge

static tl::expected<Texels, std::string> read_texels(const char* format, const std::filesystem::path& path,
                                                     int channels) {
    const auto unusable = [&](const std::string& fact) {
        return tl::unexpected(fmt::format("{}: {}", path.string(), fact));
    };
    const auto input = OIIO::ImageInput::create(format);
    OIIO::ImageSpec spec;
    if (!input || !input->open(path.string(), spec))
        return unusable(input ? input->geterror() : OIIO::geterror());
    if (spec.nchannels != channels || spec.format != OIIO::TypeDesc::UINT8)
        return unusable(fmt::format("{} channels of {}; a texture's has {} of uint8", spec.nchannels,
                                    spec.format.c_str(), channels));
    if (spec.width > kLargest || spec.height > kLargest)
        return unusable(fmt::format("{} x {} texels; a texture has at most {} along an edge", spec.width,
                                    spec.height, kLargest));
    Texels texels{spec.width, spec.height, channels, {}};
    texels.values.resize(texels.size() * static_cast<std::size_t>(channels));
    const auto row = static_cast<OIIO::stride_t>(spec.width) * channels;
    if (!input->read_image(0, 0, 0, channels, OIIO::TypeDesc::UINT8,
                           texels.values.data() + row * (spec.height - 1), channels, -row))
        return unusable(input->geterror());
    return texels;
}

tl::expected<Texels, std::string> read_png(const std::filesystem::path& path, int channels) {
    return read_texels("png", path, channels);
}

tl::expected<Texels, std::string> read_jpeg(const std::filesystem::path& path, int channels) {
    return read_texels("jpeg", path, channels);
}

}  // namespace render

// png_door.cpp finds this symbol by name.
extern "C" {
[[gnu::visibility("default")]] extern const render::PngDoor couloir_png;
const render::PngDoor couloir_png{render::encode_png, render::read_png, render::read_jpeg};
}
