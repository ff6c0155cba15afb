#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "render/view/season.h"

namespace game {

// Month and day as scenes and recordings state them, "07-15". None if the text is no such day of any year.
std::optional<render::Date> date_from(std::string_view text);
std::string to_string(render::Date date);
// Of a day of a year that has a 29 February; 0 is 1 January, 366 the same.
render::Date date_of(std::int64_t day);

}  // namespace game
