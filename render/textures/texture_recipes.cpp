#include "render/textures/texture_recipes.h"

#include <array>

#include "render/textures/gaussian.h"

namespace render {
namespace {

constexpr std::array kRecipes{
    TextureRecipe{"checkerboard", TextureKind::kStructured, 8, 0.008f, make_checkerboard},
    TextureRecipe{"stones", TextureKind::kStructured, 12, 0.030f, make_stones},
    TextureRecipe{"perlin", TextureKind::kStochastic, 10, 0.040f, make_perlin},
    TextureRecipe{"snow", TextureKind::kStochastic, 9, 0.055f, make_snow},
    TextureRecipe{"soil", TextureKind::kStochastic, 10, 0.045f, make_soil},
};

// Colours of a stochastic texture: its heights looked up in the colour table.
Picture look_up(const std::vector<std::uint8_t>& heights, const Picture& colours) {
    Picture picture{kTextureSize, kTextureSize, {}};
    for (const std::uint8_t height : heights) {
        const auto first = colours.pixels.begin() + 3 * height;
        picture.pixels.insert(picture.pixels.end(), first, first + 3);
    }
    return picture;
}

std::vector<glm::vec3> colours_of(const Gaussian& gaussian, std::span<const ColourStop> ramp) {
    std::vector<glm::vec3> colours;
    for (const float raw : gaussian.raw) colours.push_back(colour_at(ramp, raw));
    return colours;
}

}  // namespace

std::span<const TextureRecipe> texture_recipes() {
    return kRecipes;
}

std::vector<NamedPicture> make_pictures(const TextureRecipe& recipe) {
    const Surface surface = recipe.make();
    const std::string name = recipe.name;
    std::vector<NamedPicture> pictures{
        {name + "-normal.png", normal_picture(surface.heights, recipe.relief)}};
    if (recipe.kind == TextureKind::kStructured) {
        pictures.push_back({name + "-height.png", grey_picture(surface.heights)});
        pictures.push_back({name + ".png", colour_picture(surface.colours, kTextureSize)});
        return pictures;
    }
    const Gaussian gaussian = gaussianise(surface.heights);
    const Picture colours = colour_picture(colours_of(gaussian, surface.ramp), 256);
    pictures.push_back({name + "-height.png", {kTextureSize, kTextureSize, gaussian.bytes, 1}});
    pictures.push_back({name + "-colours.png", colours});
    pictures.push_back({name + ".png", look_up(gaussian.bytes, colours)});
    return pictures;
}

}  // namespace render
