#pragma once

#include <string>

namespace game {

// The beginning of a page that needs nothing from elsewhere, for light and for dark, up to and with its
// heading. `style`: what the page has of its own, CSS.
std::string begin_page(const std::string& title, const std::string& style);
// Its end. `made_by`: program and machine.
std::string end_page(const std::string& made_by);

}  // namespace game
