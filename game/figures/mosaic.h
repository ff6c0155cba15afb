#pragma once

#include <span>

#include "render/pictures/picture.h"

namespace game {

// Arranges images of one size and three channels in rows of `columns`, the first at the top left, with narrow
// white gaps. Unused places stay white.
render::Picture mosaic(std::span<const render::Picture> pictures, int columns);

}  // namespace game
