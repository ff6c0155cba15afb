#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>

#include "game/files/shelf.h"

namespace game::ui {

// Which page of the menu is open, and what is chosen there.
struct Menu {
    enum class Page : std::uint8_t { kStart, kChallenges, kFreePlay, kHill, kWatch, kSettings, kKeys, kPad };

    bool open = false;
    bool begins = false;  // the program has just started: nothing was played that could go on
    Page page = Page::kStart;
    std::string chosen =
        {};  // name of the scene whose card was clicked, or file of what was made; empty: none yet

    // Of the pages with files: what is listed to watch, nothing for what ships; and of one's own hills.
    std::optional<ShelfKind> watched = ShelfKind::kRecording;
    ShelfKind hill = ShelfKind::kWorld;
    enum class Order : std::uint8_t { kNewest, kOldest, kName } order = Order::kNewest;
    std::array<char, 64> search{};
    bool renames = false, asks_to_throw = false;  // the chosen one
    std::array<char, 128> new_name{};

    void show(Page at = Page::kStart) {
        open = true;
        page = at;
        chosen.clear();
        renames = asks_to_throw = false;
    }
    void close() { open = begins = false; }
    // From a page to the one before it, and from the start to the world.
    void back() { page == Page::kStart ? close() : show(page == Page::kPad ? Page::kKeys : Page::kStart); }
};

}  // namespace game::ui
