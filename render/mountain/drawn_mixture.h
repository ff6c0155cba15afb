#pragma once

#include <cstdint>
#include <vector>

#include "sim/world/state.h"

namespace render {

// The mixture of a world as it is drawn: two bytes per vertex, row 0 the south, for the shares of the lower material at
// the surface of the standing layer and in the rolling layer. Empty in a world of one material. Where a layer is empty,
// its mixture is copied from the neighbouring vertices, so that the layer keeps its colour up to its edge.
void drawn_mixture(const sim::View& world, std::vector<std::uint8_t>& into);

}  // namespace render
