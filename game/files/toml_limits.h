#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace game {

// What of a TOML text is beyond game/base/limits.h, with its line. The parser itself calls itself for every
// part of a dotted key, and looks through all dotted keys at each of them, so this is asked before.
struct TomlExcess {
    int line;
    std::string fact;
};
std::optional<TomlExcess> excess_of(std::string_view toml);

}  // namespace game
