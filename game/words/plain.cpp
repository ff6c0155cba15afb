#include "game/words/plain.h"

#include <array>

namespace game {
namespace {

constexpr std::array kPlainWords{
    PlainWords{"%s from A: height %s, standing %.1f m, rolling %.1f m, %.0f m/s",
               "%s from A: height %s, cover %.1f m, flow %.1f m, %.0f m/s"},
    PlainWords{"Aspect", "Faces"},
    PlainWords{"Pours into the rolling layer: it flows at once.", "What is poured flows at once."},
    PlainWords{"Pours onto the standing layer: it rests until the slope fails.",
               "What is poured lies there until the slope fails."},
    PlainWords{"Rolling", "Flow"},
    PlainWords{"Speed on slope", "Speed"},
    PlainWords{"Standing", "Cover"},
    PlainWords{"Volume of the standing and rolling layers, and volume poured, dug, and lost over the border.",
               "Volume of the cover and of the flow, and volume poured, dug, and lost over the border."},
    PlainWords{"pour onto the standing or into the rolling layer",
               "pour onto the cover, or what flows at once"},
    PlainWords{"rolling depth", "depth of the flow"},
    PlainWords{"rolling layer", "flow"},
    PlainWords{"speed in plan", "speed"},
    PlainWords{"standing %s   rolling %s   poured %s%s%s   out %s",
               "cover %s   flow %s   poured %s%s%s   out %s"},
    PlainWords{"standing depth", "depth of the cover"},
    PlainWords{"standing layer", "cover"},
};

bool plainly_now = false;

}  // namespace

std::span<const PlainWords> plain_words() {
    return kPlainWords;
}

void speak_plainly(bool plainly) {
    plainly_now = plainly;
}

bool speaks_plainly() {
    return plainly_now;
}

}  // namespace game
