#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "game/scene/scene.h"
#include "game/session/session.h"
#include "game/share/slide_page.h"

namespace game::test {

// A small slide as the program computed it, and its page.
struct SharedSlide {
    // The fields of a state that the page keeps, one value per vertex, row 0 the south.
    struct Kept {
        std::vector<float> depth, rolling, speed;  // m, m/s in plan
        std::vector<std::uint8_t> mixture;         // as render::drawn_mixture() makes it
    };

    Scenario scenario;
    std::string page;
    std::map<std::int64_t, Kept> kept;  // by tick
    Peaks peaks;
};

// Plays a scene on 48 squares along the longer side for so many ticks. `title`: instead of its own.
SharedSlide share_slide(const char* scene, std::int64_t ticks, const std::string& title = {},
                        const PageOptions& options = {});

}  // namespace game::test
