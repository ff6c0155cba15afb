#pragma once

#include <string>
#include <string_view>

#include <tl/expected.hpp>

#include "game/scene/scenario.h"

namespace game {

// The fields of a start's ground as text that fits a JSON line: bedrock, depth, rolling, in a world of two
// materials the lower one's depth (float32, little-endian) and has_data (bytes), zstd, base64.
std::string pack_ground(const Scenario& scenario);

// Fills them in from the text; start.grid and start.lower say what there must be. Errors: not such a text, of
// another length, not finite, or layers outside 0 to 64 m.
tl::expected<void, std::string> unpack_ground(std::string_view text, Scenario& scenario);

}  // namespace game
