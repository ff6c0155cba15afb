#pragma once

#include "render/pictures/picture.h"

namespace render {

// Draws the pictures of conifers that trees are shown by: assets/textures/conifers.png, bit-identical on every machine.
//
// Columns are trees (TREE_COLUMN_* of slots.glsl), rows are heights of the eye, from the lowest up (kTreeRows). A texel is red:
// the part of its normal that looks across, 128 none; green: share of snow; blue: share of the light that reaches it, at
// least 1, and 0 where no tree is. The levels are below each other, each half as large as the one before. A level covers as
// much as the first, so that trees neither thin out nor swell as they go away.
Picture conifer_pictures();

}  // namespace render
