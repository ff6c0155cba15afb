#include "files/module.h"
#include "terrains/grey_picture.h"

// OpenImageIO comes with over two hundred libraries, so it is linked to a module of its own, which is loaded
// when it is first asked. The real function, which the module has, is in grey_picture.cpp.
namespace terrains {

tl::expected<GreyPicture, std::string> read_grey_picture(const std::filesystem::path& path) {
    static const auto* read = static_cast<const decltype(&read_grey_picture)*>(
        files::symbol_of_module("libcouloir_pictures.so", "couloir_read_grey_picture"));
    return (*read)(path);
}

}  // namespace terrains
