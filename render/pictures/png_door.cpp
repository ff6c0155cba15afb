#include "files/module.h"
#include "render/pictures/png.h"

namespace render {
namespace {

const PngDoor& door() {
    static const auto* opened =
        static_cast<const PngDoor*>(files::symbol_of_module("libcouloir_pictures.so", "couloir_png"));
    return *opened;
}

}  // namespace

tl::expected<std::vector<unsigned char>, std::string> encode_png(const Picture& picture,
                                                                 const PngCompression& compression,
                                                                 const PngTexts& texts) {
    return door().encode_png(picture, compression, texts);
}

tl::expected<Texels, std::string> read_png(const std::filesystem::path& path, int channels) {
    return door().read_png(path, channels);
}

tl::expected<Texels, std::string> read_jpeg(const std::filesystem::path& path, int channels) {
    return door().read_jpeg(path, channels);
}

}  // namespace render
