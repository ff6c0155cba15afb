#pragma once

#include <initializer_list>
#include <string>
#include <string_view>
#include <utility>

namespace game {

// Replaces every slot of a text, such as @NAME@, by what belongs there; what was put in is not looked through.
std::string filled(std::string_view text,
                   std::initializer_list<std::pair<std::string_view, std::string_view>> slots);

}  // namespace game
