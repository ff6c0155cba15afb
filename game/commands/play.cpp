#include <fmt/format.h>

#include "game/app.h"
#include "game/commands/commands.h"
#include "game/window.h"

namespace game {

Outcome<int> play(const PlayOptions& options) {
    auto window = Window::open("Couloir", options.size.width, options.size.height);
    if (!window) return tl::unexpected(window.error());
    auto app = App::begin(**window, options);
    if (!app) return tl::unexpected(app.error());
    while ((*app)->frame()) {
    }
    if (auto finished = (*app)->finish(); !finished) return tl::unexpected(finished.error());
    if (const auto& recording = (*app)->recording())
        fmt::print("{:.1f} s played; couloir replay {} plays it again\n",
                   (*app)->sandbox().session().seconds(), recording->string());
    return 0;
}

}  // namespace game
