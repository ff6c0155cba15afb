#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace game {

// Finds what exceeds game/base/limits.h in a TOML text, with its line. Call it before parsing: the parser
// recurses for every part of a dotted key, and searches all dotted keys for each of them.
struct TomlExcess {
    int line;
    std::string fact;
};
std::optional<TomlExcess> excess_of(std::string_view toml);

}  // namespace game
