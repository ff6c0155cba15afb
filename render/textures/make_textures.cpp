#include <cstdio>
#include <filesystem>
#include <utility>
#include <vector>

#include "render/pictures/picture.h"
#include "render/textures/texture_recipes.h"
#include "render/textures/tree_pictures.h"

// make_textures FOLDER: writes every image of every recipe into an existing folder. Exit status 1 if an image
// cannot be written, 2 without a folder.
int main(int count, char** arguments) {
    if (count != 2) {
        std::fputs("make_textures FOLDER\n", stderr);
        return 2;
    }
    std::vector<render::NamedPicture> pictures{{"conifers.png", render::conifer_pictures()},
                                               {"trees-in-leaf.png", render::leaf_pictures()}};
    for (const render::TextureRecipe& recipe : render::texture_recipes())
        for (render::NamedPicture& each : render::make_pictures(recipe)) pictures.push_back(std::move(each));
    for (const auto& [file, picture] : pictures) {
        const auto written = render::write_png(picture, std::filesystem::path(arguments[1]) / file,
                                               render::kSmallestPngCompression);
        if (written) continue;
        std::fprintf(stderr, "make_textures: %s\n", written.error().c_str());
        return 1;
    }
    return 0;
}
