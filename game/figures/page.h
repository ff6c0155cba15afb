#pragma once

#include <span>
#include <string>
#include <vector>

#include "game/pages/table.h"

namespace game {

// A figure on the page. Strings are plain UTF-8.
struct PageFigure {
    struct Shown {
        std::string file;  // relative to the page
        std::string note;
    };
    int number;  // in the paper
    std::string title, caption;
    std::vector<Shown> pictures;
    bool stretch = false;  // images use the colours of render::Overlay::kStretch
};

// All figures and tables as one HTML page that needs only
// the images beside it. `made_by`: program and renderer.
std::string page_of(std::span<const PageFigure> figures, std::span<const Table> tables,
                    const std::string& made_by);

}  // namespace game
