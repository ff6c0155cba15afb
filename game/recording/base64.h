#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace game {

// Bytes as text, by RFC 4648 with padding.
std::string to_base64(std::string_view bytes);
// The bytes of such a text. Nothing for any other text: strange letters, a wrong length, bits left over.
std::optional<std::string> from_base64(std::string_view text);

}  // namespace game
