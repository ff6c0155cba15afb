#pragma once

#include <span>
#include <string>
#include <vector>

#include "render/pictures/picture.h"
#include "render/textures/surface.h"

// Procedural textures of assets/textures: kTextureSize² texels that repeat without a seam, bit-identical on
// every machine. assets/textures/README.md says what they are used for.
namespace render {

enum class TextureKind {
    kStructured,  // its colours form shapes: one copy shows at a place, never a blend
    kStochastic,  // copies are blended by height, before the colour table is applied
};

struct TextureRecipe {
    const char* name;
    TextureKind kind;
    int features;  // approximate number of its largest pieces along an edge of the tile
    float relief;  // range of raw height, tile edges
    Surface (*make)();
};

// In the order of the table in assets/textures/README.md.
std::span<const TextureRecipe> texture_recipes();

struct NamedPicture {
    std::string file;
    Picture picture;
};

// Makes every image of a texture: NAME.png (its appearance), NAME-height.png (raw for a structured texture,
// Gaussian for a stochastic one), NAME-normal.png (of the raw heights), and for a stochastic one
// NAME-colours.png, a row of 256 colours for the grey values of the heights.
std::vector<NamedPicture> make_pictures(const TextureRecipe& recipe);

}  // namespace render
