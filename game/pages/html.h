#pragma once

#include <optional>
#include <string>

namespace game {

// Returns the start of a self-contained page, for light and dark themes, up to and including its heading.
// `style`: the page's own CSS. `reload_s`: a browser loads the page again every so many seconds.
std::string begin_page(const std::string& title, const std::string& style,
                       std::optional<int> reload_s = std::nullopt);
// Returns the end of the page. `made_by`: program and machine.
std::string end_page(const std::string& made_by);

}  // namespace game
