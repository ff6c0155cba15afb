#include "tests/web/shared_slide.h"

#include <cmath>

#include "game/analysis/headless.h"
#include "render/mountain/drawn_mixture.h"
#include "tests/game/program.h"
#include "tests/support/places.h"

namespace game::test {
namespace {

constexpr int kSquares = 48;

SharedSlide::Kept kept_of(const sim::View& world) {
    SharedSlide::Kept kept;
    for (int y = 0; y < world.grid.ny; ++y)
        for (int x = 0; x < world.grid.nx; ++x) {
            const float rolling = world.rolling.row(y)[x];
            kept.depth.push_back(world.depth.row(y)[x]);
            kept.rolling.push_back(rolling);
            kept.speed.push_back(rolling >= Peaks::kVisible
                                     ? std::hypot(world.velocity_x.row(y)[x], world.velocity_y.row(y)[x])
                                     : 0);
        }
    render::drawn_mixture(world, kept.mixture);
    return kept;
}

}  // namespace

SharedSlide share_slide(const char* name, std::int64_t ticks, const std::string& title,
                        const PageOptions& options) {
    Overrides overrides;
    overrides.squares = kSquares;
    Scene scene = load_scene(name, overrides).value();
    if (!title.empty()) scene.scenario.title = title;
    auto session = Session::begin(scene.scenario, {}, std::nullopt).value();
    session.follow_powder(scene.scenario);
    auto page = SlidePage::begin(scene.scenario, session, "couloir replay it --verify", options).value();

    SharedSlide slide{scene.scenario, {}, {}, {}};
    const auto keep = [&](const Session& now) {
        const std::int64_t tick = now.state().tick;
        if (tick % PageOptions::kEvery == 0 || tick == ticks) slide.kept[tick] = kept_of(now.view());
    };
    keep(session);
    Watchers watchers;
    watchers.after_tick = keep;
    watchers.keep = [&](const Session& now) { return page.see(now); };
    play_headless(session, scene.commands, Until::after(ticks), watchers, scene.scenario.title).value();
    const support::TemporaryFolder folder;
    page.write(folder.path() / "slide.html", session, scene.commands).value();
    slide.page = read_bytes(folder.path() / "slide.html");
    slide.peaks = session.peaks();
    return slide;
}

}  // namespace game::test
