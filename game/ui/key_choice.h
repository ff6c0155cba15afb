#pragma once

#include <cstddef>
#include <optional>
#include <span>

#include "game/controls/events.h"
#include "game/controls/key_map.h"

namespace game::ui {

// A row of the key map that is about to get another key.
struct KeyChoice {
    std::optional<std::size_t> row = {};
    bool asks = false;              // the next key that is pressed is for it; Escape ends that
    bool asked = false;             // the same as the current frame began: its keys do nothing else
    std::optional<Chord> got = {};  // which was pressed, until the page has looked at it

    void ask(std::size_t for_row) { row = for_row, asks = true, got.reset(); }
    void end() { row.reset(), got.reset(), asks = false; }
    // Looks for the first press of a key among the events of a frame, if one is asked for.
    void hear(std::span<const Event> events);
};

}  // namespace game::ui
