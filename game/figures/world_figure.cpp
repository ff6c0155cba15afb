#include "game/figures/world_figure.h"

#include <algorithm>

#include <fmt/format.h>

#include "game/analysis/headless.h"
#include "game/files/assets.h"
#include "game/recording/recording_file.h"
#include "game/scene/shipped_look.h"

namespace game {

std::vector<WorldFigure> world_figures() {
    const render::Camera slope{{80, 94, -26}, 207, 36, 225, 35};
    const render::Camera valley{{1000, 1210, 1590}, 158, 32, 1900, 35};
    return {{11, "a landslide down a slope", "landslide", {420, 780, 1080}, slope},
            {12, "a snow avalanche down a valley", "snow-avalanche", {1200, 2160}, valley}};
}

Outcome<PageFigure> draw_world(const WorldFigure& figure, const std::filesystem::path& folder,
                               PictureSize size, const std::string& gl, const sim::StepOptions& options) {
    const auto path = find_asset(AssetKind::kRecording, figure.recording);
    if (!path) return tl::unexpected(path.error());
    auto recording = read_recording(*path);
    if (!recording) return tl::unexpected(recording.error());
    Scenario& scenario = recording->header.scenario;
    scenario.camera = figure.camera;
    if (auto taken = take_look(LookFrom::kShipped, scenario); !taken) return tl::unexpected(taken.error());
    auto session = Session::begin(scenario, options, std::nullopt);
    if (!session) return tl::unexpected(session.error());
    session->follow_fronts(scenario);
    session->follow_powder(scenario);
    session->follow_carried(scenario);
    auto gallery = Gallery::open(folder, size, gl, scenario);
    if (!gallery) return tl::unexpected(gallery.error());

    PageFigure shown{figure.number,
                     figure.title,
                     fmt::format("{}×{} squares; shipped recording {}.", scenario.grid.nx - 1,
                                 scenario.grid.ny - 1, figure.recording),
                     {}};
    Watchers watchers;
    watchers.after_tick = [&](const Session& now) {
        if (!std::binary_search(figure.ticks.begin(), figure.ticks.end(), now.state().tick)) return;
        const std::string name = fmt::format("figure-{:02}-{}", figure.number, shown.pictures.size() + 1);
        gallery->draw(now, name);
        shown.pictures.push_back({name + ".png", fmt::format("after {:.0f} s", now.seconds())});
    };
    const auto until = Until::after(figure.ticks.back());
    if (auto played = play_headless(*session, recording->commands, until, watchers,
                                    fmt::format("figure {}", figure.number));
        !played)
        return tl::unexpected(played.error());
    if (auto closed = gallery->close(); !closed) return tl::unexpected(closed.error());
    return shown;
}

}  // namespace game
