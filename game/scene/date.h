#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "render/view/season.h"

namespace game {

// Month and day as scenes and recordings state them, "07-15". None if the text is no such day of any year.
std::optional<render::Date> date_from(std::string_view text);
std::string to_string(render::Date date);

}  // namespace game
