#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace game {

// Encodes bytes as text, by RFC 4648 with padding.
std::string to_base64(std::string_view bytes);
// Decodes such a text. Returns nothing for any other text: unknown letters, a wrong length, leftover bits.
std::optional<std::string> from_base64(std::string_view text);

}  // namespace game
