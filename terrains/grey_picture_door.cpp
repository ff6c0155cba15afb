#include "files/module.h"
#include "terrains/grey_picture.h"

// OpenImageIO depends on over two hundred libraries, so a separate module links it and is loaded on first
// use. The real function is in that module, in grey_picture.cpp.
namespace terrains {

tl::expected<GreyPicture, std::string> read_grey_picture(const std::filesystem::path& path) {
    static const auto* read = static_cast<const decltype(&read_grey_picture)*>(
        files::symbol_of_module("libcouloir_pictures.so", "couloir_read_grey_picture"));
    return (*read)(path);
}

}  // namespace terrains
