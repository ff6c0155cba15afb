#pragma once

#include <cstdint>
#include <string>

namespace game::ui {

// Which page of the menu is open, and what is chosen there.
struct Menu {
    enum class Page : std::uint8_t { kStart, kChallenges, kFreePlay, kHill, kWatch, kSettings, kKeys, kPad };

    bool open = false;
    bool begins = false;  // the program has just started: nothing was played that could go on
    Page page = Page::kStart;
    std::string chosen = {};  // name of the scene whose card was clicked; empty: none yet

    void show(Page at = Page::kStart) {
        open = true;
        page = at;
        chosen.clear();
    }
    void close() { open = begins = false; }
    // From a page to the one before it, and from the start to the world.
    void back() { page == Page::kStart ? close() : show(page == Page::kPad ? Page::kKeys : Page::kStart); }
};

}  // namespace game::ui
