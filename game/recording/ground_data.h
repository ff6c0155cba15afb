#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <tl/expected.hpp>

#include "game/scene/scenario.h"

namespace game {

// Encodes a scenario's ground as text for a JSON line: bedrock, depth, rolling, the lower material's depth if
// there is one (float32, little-endian) and has_data (bytes); zstd, then base64.
std::string pack_ground(const Scenario& scenario);

// Decodes them; scenario.grid and scenario.lower determine what is expected. Errors: not such a text, a wrong
// length, values that are not finite, or layers outside 0 to 64 m.
tl::expected<void, std::string> unpack_ground(std::string_view text, Scenario& scenario);

// The same for one byte per vertex. Errors of the second: not such a text, or not `count` bytes.
std::string pack_bytes(std::span<const std::uint8_t> bytes);
tl::expected<std::vector<std::uint8_t>, std::string> unpack_bytes(std::string_view text, std::size_t count);

// The same for metres at each vertex. Errors of the second also: a value that is not finite.
std::string pack_metres(std::span<const float> metres);
tl::expected<std::vector<float>, std::string> unpack_metres(std::string_view text, std::size_t vertices);

// The same for the stems at each vertex: standing (two bytes, little-endian), lying, diameter and height, a plane each.
// Errors of the second also: stems beyond kMostStems, or sizes that no planted tree has.
std::string pack_forest(std::span<const sim::Stems> forest);
tl::expected<std::vector<sim::Stems>, std::string> unpack_forest(std::string_view text, std::size_t vertices);

}  // namespace game
