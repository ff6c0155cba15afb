#pragma once

#include <array>
#include <string>

#include "game/base/outcome.h"
#include "game/share/slide_page.h"

namespace game {

// One of two slides that are compared.
struct BesideSlide {
    std::string title;
    std::string page;  // as SlidePage makes it, which nobody can take over
};

// A page that shows two slides side by side, or one below the other on a narrow screen. They share time, colours and, on ground
// of the same extent, the view: what is done to one is done to the other. Errors: the files of pages are missing (3).
Outcome<std::string> beside_page(const std::array<BesideSlide, 2>& slides);

}  // namespace game
