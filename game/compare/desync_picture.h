#pragma once

#include <array>
#include <string>

#include "game/recording/divergence.h"
#include "render/pictures/picture.h"

namespace game {

// An image of which cells of two runs differ at the end of the tick in which they part, on the ground from
// above; the first cell and its surroundings, enlarged; and a short form of to_text().
render::Picture desync_picture(const Divergence& parted, const Scenario& scenario,
                               const std::array<std::string, 2>& names);

}  // namespace game
