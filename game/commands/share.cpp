#include <fmt/format.h>

#include "game/base/print.h"
#include "game/commands/commands.h"
#include "game/files/assets.h"
#include "game/files/file_use.h"
#include "game/files/text_file.h"
#include "game/scene/viewpoint.h"
#include "game/session/loaded_world.h"
#include "game/share/share_recording.h"

namespace game {

Outcome<int> share(const ShareOptions& options) {
    Overrides overrides;
    overrides.memory = options.memory;
    overrides.memory.use.page = true;
    if (options.lesson.has_value() != options.world.empty())
        return unusable(
            "share takes either a world or --lesson, which has its own recording: couloir share --lesson "
            "NAME --out page.html");
    auto opened =
        options.lesson ? open_lesson(*options.lesson, overrides) : open_anything(options.world, overrides);
    if (!opened) return tl::unexpected(opened.error());
    Scenario& scenario = opened->scene.scenario;
    if (options.view)
        if (auto looked = look_from(*options.view, scenario); !looked) return tl::unexpected(looked.error());
    FileUse use;
    use.reads(opened->scene.files).reads(page_assets()).writes("--out", options.out);
    if (auto sound = use.check(); !sound) return tl::unexpected(sound.error());
    if (auto placed = make_place_for(options.out); !placed) return tl::unexpected(placed.error());
    const auto written = write_page_of_loaded(
        *opened, options.out,
        {.most_bytes = options.most_bytes, .camera = scenario.camera, .plays = !options.watch_only});
    if (!written) return tl::unexpected(written.error());
    for (const std::string& notice : written->notices) print_line(stderr, "couloir: {}", notice);
    print_line(stdout, "{}: {:.1f} MB; {}", options.out.string(), static_cast<double>(written->bytes) / 1e6,
               options.watch_only ? "opens in any browser"
                                  : "opens in any browser, and whoever opens it can take over");
    return 0;
}

}  // namespace game
