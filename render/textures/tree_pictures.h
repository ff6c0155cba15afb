#pragma once

#include "render/pictures/picture.h"

namespace render {

// Draw the pictures that trees are shown by, bit-identical on every machine: assets/textures/conifers.png has the trees of a
// winter, and assets/textures/trees-in-leaf.png those that are besides them on a day of the year.
//
// Columns are trees (TREE_COLUMN_* of slots.glsl), rows are heights of the eye, from the lowest up (TREE_ROW_SINES). A texel is red:
// the part of its normal that looks across, 128 none; green: share of snow, or of bark of a tree in leaf; blue: share of the light
// that reaches it, at least 1, and 0 where no tree is. The levels are below each other, each half as large as the one before. A
// level covers as much as the first, so that trees neither thin out nor swell as they go away.
Picture conifer_pictures();
Picture leaf_pictures();

}  // namespace render
