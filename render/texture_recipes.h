#pragma once

#include <span>
#include <string>
#include <vector>

#include "render/picture.h"
#include "render/textures/surface.h"

// The textures under assets/textures, made from rules: kTextureSize² texels that repeat without a seam, the
// same bits on every machine. assets/textures/README.md says what they are for.
namespace render {

enum class TextureKind {
    kStructured,  // its colours have shapes: one copy shows at a place, never a blend
    kStochastic,  // copies are blended by height, before the colour table
};

struct TextureRecipe {
    const char* name;
    TextureKind kind;
    int features;  // how many of its largest pieces lie along an edge of the tile, about
    float relief;  // from the lowest to the highest raw height, tile edges
    Surface (*make)();
};

// In the order of the table in assets/textures/README.md.
std::span<const TextureRecipe> texture_recipes();

struct NamedPicture {
    std::string file;
    Picture picture;
};

// Every picture of a texture: NAME.png (what one sees), NAME-height.png (raw for a structured texture,
// Gaussian for a stochastic one), NAME-normal.png (of the raw heights), and for a stochastic one
// NAME-colours.png, a row of 256 colours for the grey values of the heights.
std::vector<NamedPicture> make_pictures(const TextureRecipe& recipe);

}  // namespace render
