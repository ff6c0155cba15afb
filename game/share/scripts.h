#pragma once

#include <string>
#include <string_view>

#include "game/recording/format.h"

namespace game {

// What a policy calls the scripts of a page: 'sha256-…' of each element without attributes. Only they may run, whatever
// else the page was made to hold.
std::string names_of_scripts(std::string_view page);

// JSON that ends no script element and means the same, but for what is not printable.
std::string in_script(const Json& json);

}  // namespace game
